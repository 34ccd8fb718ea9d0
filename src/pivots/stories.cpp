// What the variables and pivots of a problem mean.
#include "lcpush/desktop/jam.hpp"
#include "lcpush/desktop/pivots.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

class PushStory : public Story {
public:
  explicit PushStory(const Push& push) : push_(push) {}

  bool is_physical() const override { return true; }

  std::string meaning(Index variable) const override {
    const Index n = size();
    if (variable == artificial(n)) return "artificial variable: helps every violated law";
    const bool is_unknown = variable >= n;
    const Index i = is_unknown ? variable - n : variable;
    const Meaning meaning = name_of(push_.layout(), i).meaning;
    const bool is_closing = meaning == Meaning::closing, is_slip = meaning == Meaning::slip;
    if (is_unknown)
      return push_.variable_name(i) + (is_closing ? ", counted from its bound -S (m/s^2)"
                                       : is_slip  ? " (m/s^2)"
                                                  : " (N)");
    return push_.row_name(i) + (is_closing ? "" : is_slip ? " (N)" : " (m/s^2)");
  }

  std::string sentence(const TracedPivot& pivot, const std::vector<bool>& basic) const override {
    const std::string begin = pivot.entering == artificial(size())
                                  ? "The artificial variable z0 enters, just large enough for "
                                    "every law to hold with its help; "
                                  : "As " + grows(pivot.entering, "the") + ", ";
    return begin + ends(pivot.leaving, basic) + ".";
  }

  std::string growth(Index variable) const override { return grows(variable, "the"); }
  std::string end(Index variable) const override { return ends(variable, {}); }

  std::string ray_sentence(Index entering, const std::vector<double>& v) const override {
    const Layout<double>& layout = push_.layout();
    std::vector<double> own(v.size());
    double largest = 0;
    for (Index i = 0; i < layout.size; ++i) {
      own[static_cast<std::size_t>(i)] = v[static_cast<std::size_t>(i)] / unknown_unit(layout, i);
      largest = std::max(largest, own[static_cast<std::size_t>(i)]);
    }
    for (double& x : own) x /= largest > 0 ? largest : 1;
    const Jam jam = explain_jam(push_.file(), push_.assembly(), own.data(),
                                layout.size <= 200 ? has_answer : nullptr);
    return grows(entering, "The") + " without end: nothing blocks.\n" +
           joined(jam_sentences(push_.file(), jam), "\n");
  }

private:
  const Push& push_;

  Index size() const { return push_.layout().size; }
  std::string point(const Name& name) const { return point_name(push_.file(), name.of); }

  /// The way a point slides: towards the side against which its friction acts. A facet of the
  /// pyramid leaves a sector open, and a basis that is not known (empty) every side.
  std::string sliding(Index at, const std::vector<bool>& basic) const {
    if (basic.empty()) return "";
    Generator<double> friction{Vector3<double>::Zero(), 0};
    for (Index j = 0; j < push_.layout().cones[at].generators; ++j) {
      const Index variable = unknown(push_.layout().friction_index(at, j), size());
      if (!basic[static_cast<std::size_t>(variable)]) continue;
      const Body<double>& body = push_.scene().bodies[push_.layout().body[at]];
      const Generator<double> d = generator(body, j, push_.file().facets);
      friction.force += d.force;
      friction.torque += d.torque;
    }
    const double slide = friction.force.norm();
    std::string text;
    if (slide > 1e-9) text = " towards " + direction_text(-friction.force / slide);
    if (friction.torque != 0) text += text.empty() ? " by turning" : ", turning";
    return text;
  }

  /// What the entering variable's growth is.
  std::string grows(Index variable, const std::string& the) const {
    const Index n = size();
    if (variable == artificial(n)) return the + " artificial variable z0 grows";
    const bool is_unknown = variable >= n;
    const Name name = name_of(push_.layout(), is_unknown ? variable - n : variable);
    switch (name.meaning) {
    case Meaning::normal:
      return point(name) + (is_unknown ? " presses harder" : " separates faster");
    case Meaning::pull: return point(name) + (is_unknown ? " pulls harder" : " approaches faster");
    case Meaning::friction:
      return is_unknown ? "friction of " + point(name) + push_.along(name, 1) + " grows"
                        : point(name) + " turns away from sliding" + push_.along(name, -1);
    case Meaning::slip:
      return is_unknown ? point(name) + " slides faster"
                        : the + " friction of " + point(name) + " draws back from its cone";
    case Meaning::closing:
      return is_unknown ? push_.actuator_name(name.of) + " closes faster or retreats less"
                        : the + " force of " + push_.actuator_name(name.of) +
                              " grows beyond its set force";
    }
    return {};
  }

  /// What has happened when the leaving variable is zero, and what may follow. `basic` may be
  /// empty.
  std::string ends(Index variable, const std::vector<bool>& basic) const {
    const Index n = size();
    if (variable == artificial(n)) return "the artificial variable z0 is gone: every law holds";
    const bool is_unknown = variable >= n;
    const Name name = name_of(push_.layout(), is_unknown ? variable - n : variable);
    switch (name.meaning) {
    case Meaning::normal:
      return is_unknown ? point(name) + " presses no more and may separate"
                        : point(name) + " touches and may press";
    case Meaning::pull:
      return is_unknown ? point(name) + " pulls no more"
                        : point(name) + " is held and may be pulled";
    case Meaning::friction:
      return is_unknown
                 ? "the friction of " + point(name) + push_.along(name, 1) + " has faded away"
                 : "the object moves" + push_.along(name, -1) + " at " + point(name) +
                       " as fast as it slips, so that friction" + push_.along(name, 1) + " may act";
    case Meaning::slip:
      return is_unknown ? point(name) + " stops sliding and sticks"
                        : point(name) + " reaches its friction cone and starts to slide" +
                              sliding(name.of, basic);
    case Meaning::closing:
      return is_unknown ? push_.actuator_name(name.of) + " retreats at its bound"
                        : push_.actuator_name(name.of) + " holds its set force and may move";
    }
    return {};
  }
};

} // namespace

std::unique_ptr<Story> push_story(const Push& push) { return std::make_unique<PushStory>(push); }

std::string variable_name(Index variable, Index n) {
  if (variable == artificial(n)) return "z0";
  return variable < n ? "w" + std::to_string(variable + 1) : "z" + std::to_string(variable - n + 1);
}

std::string RawStory::meaning(Index variable) const {
  if (variable == artificial(n_)) return "artificial variable, times the cover d in every row";
  const std::string number = std::to_string((variable < n_ ? variable : variable - n_) + 1);
  return variable < n_ ? "slack of row " + number : "unknown " + number;
}

std::string RawStory::sentence(const TracedPivot& pivot, const std::vector<bool>&) const {
  const std::string in = variable_name(pivot.entering, n_), out = variable_name(pivot.leaving, n_);
  std::vector<std::string> tied;
  for (const Index variable : pivot.ties) tied.push_back(variable_name(variable, n_));
  if (pivot.entering == artificial(n_)) {
    const std::string enters = "z0 enters, just large enough to make every value >= 0; ";
    if (tied.empty()) return enters + out + " needs it most.";
    return enters + listed(tied, "and") + " need it most, and " + out + " leaves.";
  }
  std::string text = "As " + in + " grows, ";
  text += tied.empty() ? out + " falls to zero first"
                       : listed(tied, "and") + " fall to zero together, and " + out + " leaves";
  if (pivot.leaving == artificial(n_)) return text + ": this basis solves the problem.";
  return text + "; its complement " + variable_name(complement(pivot.leaving, n_), n_) +
         " enters next.";
}

std::string RawStory::ray_sentence(Index entering, const std::vector<double>&) const {
  return variable_name(entering, n_) +
         " may grow without end: nothing blocks, and z0 never reaches zero.";
}

} // namespace lcpush::desktop
