// The parts of the page below its first screen.
#pragma once

#include <string>

#include "lcpush/desktop/report_page.hpp"

namespace lcpush::desktop {

/// A part of the page; `inside` is HTML.
struct Section {
  std::string id, title, inside;
};

std::string failure_box(const std::string& inside);
/// Why there is no answer: the reason, who squeezes whom, the ray.
std::string failure_html(const SceneFile& file, const RunReport& report);
std::string sweep_title(const Sweep& sweep);

/// Precondition of those of friction, contacts and laws: the push is solved.
Section friction_section(const PageContent& content);
Section contacts_section(const PageContent& content);
Section breaking_section(const PageContent& content);
Section holding_section(const PageContent& content);
Section sweeps_section(const PageContent& content);
Section residual_section(const PageContent& content);
/// What was asked: the object, the hand and the pusher, the laws, the scene's file.
Section inputs_section(const PageContent& content);

} // namespace lcpush::desktop
