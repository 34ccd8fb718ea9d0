// The field's own contact problem: r and u with u = W r + b, and Signorini's and Coulomb's laws at
// every contact. Read, solved with round or pyramid friction, judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// k contacts, three rows each: the normal, then two tangents. e equalities, as grips of a hand:
///
///   u = W r + V l + b,   V' r + R l + s = 0,   0 <= r_n _|_ u_n >= 0,   |r_t| <= mu r_n,
///   r_t opposite to u_t, |r_t| = mu r_n where u_t is not 0.
struct ContactProblem {
  SparseRows W;                     ///< 3k x 3k, symmetric, positive semidefinite
  Eigen::VectorXd b;                ///< 3k
  Eigen::VectorXd mu;               ///< k
  Eigen::MatrixXd V;                ///< 3k x e
  Eigen::VectorXd R;                ///< e, the diagonal, <= 0
  Eigen::VectorXd s;                ///< e
  std::optional<Eigen::VectorXd> r; ///< 3k: somebody's, to be judged
  bool normal_last = false;         ///< in the file, and in what is written: tangents come first
  std::vector<std::string> unread;  ///< keys of the file that say nothing here

  Index contacts() const { return mu.size(); }
};

enum class ForceMode { open, stick, slip };
constexpr const char* force_mode_texts[] = {"open", "stick", "slip"};

/// The laws, each by how much it is broken: velocities as parts of the contact's b and of what its
/// own force does, or of all terms of its rows where the forces' digits leave these open; forces as
/// parts of what makes such velocities. `dissipation` is the angle (rad) of friction off the slip,
/// or what its size lacks as a part of mu r_n; `natural_map` is |r - P(r - u - mu |u_t| n)|, P the
/// nearest point of the cone (De Saxce's form of all laws in one).
enum class ContactLaw { signorini, cone, dissipation, natural_map, equalities };
constexpr Index contact_law_count = 5;

struct ContactResidual {
  double size = 0;
  Index contact = -1; ///< where; of equalities, which one
};

struct ContactForces {
  bool is_good = false;      ///< solved, or what was given is right
  Index facets = 0;          ///< of pyramids; 0: round cones
  std::optional<double> lcp; ///< of pyramids that are solved: the residual of their problem [T.11]
  /// There are no forces: with these weights >= 0, one a contact, the normal velocities sum up to
  /// less than 0 whatever presses. Empty: not known.
  Eigen::VectorXd none;
  double tolerance = 0; ///< of the residuals
  Eigen::VectorXd r, u, l;
  std::vector<ForceMode> modes;
  std::vector<Eigen::Matrix<double, contact_law_count, 1>> broken; ///< by contact; equalities 0
  ContactResidual worst[contact_law_count];
};

constexpr double usual_contact_tolerance = 1e-6; ///< of others: printed in seven digits

/// A JSON file or a folder of Matrix Market files. Throws InputError.
ContactProblem read_contacts(const std::string& path, bool normal_last);
ContactProblem parse_contacts(const std::string& text, const std::string& name, bool normal_last);
/// Somebody's forces: JSON with "r", an array, or a Matrix Market file.
void read_contact_forces(const std::string& path, ContactProblem& problem);

ContactForces solve_contacts(const ContactProblem& problem);
/// With pyramids of so many facets inside of the cones, by Lemke's pivots; `turns`: of each
/// contact's, rad; empty: none is turned.
ContactForces solve_contact_pyramids(const ContactProblem& problem, Index facets,
                                     const Eigen::VectorXd& turns = {});
/// The residuals of r; what V needs beside it, l, is fitted unless it is given.
ContactForces judge_contacts(const ContactProblem& problem, const Eigen::VectorXd& r,
                             double tolerance, const Eigen::VectorXd* l = nullptr);

/// Does W leave these normal forces' velocities alone, while b lets their points close? Then no
/// forces keep them from it, and these are the weights that show it; else empty.
Eigen::VectorXd contradiction(const ContactProblem& problem, const Eigen::VectorXd& r);
/// The same, looked for by a linear program, whatever friction is; of many contacts not. Cost: O(k)
/// pivots of O(k^2).
Eigen::VectorXd find_contradiction(const ContactProblem& problem);

/// The same numbers, read with the normal at the other place.
ContactProblem in_other_order(ContactProblem problem);
/// Of refused forces: signs turned round, or another order, with which they fit; empty: none does.
std::string contact_hint(const ContactProblem& problem, const ContactForces& refused);

std::string contacts_text(const ContactProblem& problem, const ContactForces& answer, bool all);
std::string contacts_json(const ContactProblem& problem, const ContactForces& answer);

} // namespace lcpush::desktop
