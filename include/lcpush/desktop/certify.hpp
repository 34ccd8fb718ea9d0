// Proofs of answers: exact numbers that anybody's whole-number arithmetic can check.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/push.hpp"
#include "lcpush/desktop/raw_problem.hpp"

namespace lcpush::desktop {

/// What is proved, in the order of docs/check/certificates.md.
enum class Proof {
  answer,      ///< x solves the exact problem
  squeeze,     ///< forces that balance, load no actuator, and that the push works against
  cannot_hold, ///< a motion that no force inside the friction cones opposes: the object falls
  no_answer,   ///< a raw problem: a combination of its rows says 0 < 0
};

/// As JSON spells it.
constexpr const char* proof_text(Proof proof) {
  constexpr const char* texts[] = {"answer", "squeeze", "cannot_hold", "no_answer"};
  return texts[static_cast<int>(proof)];
}

/// What an accepted certificate says, in one sentence.
constexpr const char* proof_statement(Proof proof) {
  constexpr const char* sentences[] = {
      "These numbers solve every law of the problem without any error.",
      "These forces balance inside the friction cones, load no actuator, and the push tightens "
      "them.",
      "No forces inside the friction cones balance the load: this motion gains more than they "
      "take.",
      "These weights add the rows up to a contradiction: no z >= 0 makes every w >= 0."};
  return sentences[static_cast<int>(proof)];
}

struct Certificate {
  Proof proof = Proof::answer;
  std::string law;                       ///< "literal" or "raw"
  Index facets = 0;                      ///< of a scene
  Rational push = 1;                     ///< the prescribed motions are this times the scene's
  std::vector<std::string> fingerprints; ///< of the scene, or of M and q; JSON adds that of x
  std::vector<Index> basis;              ///< pairs whose x is basic, from 0 on
  std::vector<Rational> x;               ///< every unknown; SI units

  /// Ties it to one more file with these bytes.
  void add_fingerprint(const std::string& bytes);

  double distance = 0; ///< of an answer's forces from the printed ones, over the largest
  std::vector<unsigned char> free; ///< of a raw problem
};

/// Of all laws but `even`, which gives points forces of their own: the exact answer of the literal
/// equations next to `answer`, which the scene of `text` has under `push` times its motions.
/// `file` is that scene as it was solved (its law, its facets). nullopt if none was found.
std::optional<Certificate> certify_answer(const std::string& text, const SceneFile& file,
                                          const Answer<double>& answer, double push);
/// Of a ray: forces that squeeze the object, or nullopt.
std::optional<Certificate> certify_squeeze(const std::string& text, const SceneFile& file,
                                           const std::vector<NamedValue>& ray);

/// Of a scene that does not hold its load without a push, or nullopt: some forces would.
std::optional<Certificate> certify_cannot_hold(const std::string& text, const SceneFile& file);

/// Of what `report` says of the scene's push, as the three above.
std::optional<Certificate> certify_push(const std::string& text, const SceneFile& file,
                                        const PushReport& report);
/// Of the push by `pusher` that breaks the grasp. `push` is solved once more.
std::optional<Certificate> certify_break(const std::string& text, const SceneFile& file, Push& push,
                                         Index pusher, const BreakReport& report);
/// Why answers of a scene have no certificate, "proves .."; empty if they can have one.
std::string uncertified_law(const SceneFile& file);

/// Of a raw problem with these typed numbers: of its answer, or that there is none.
std::optional<Certificate> certify_raw(const ExactMatrix& M, const ExactMatrix& q,
                                       const std::vector<unsigned char>& free,
                                       const RawAnswer& answer);

/// For the file; docs/check/certificates.md.
std::string certificate_json(const Certificate& certificate);

} // namespace lcpush::desktop
