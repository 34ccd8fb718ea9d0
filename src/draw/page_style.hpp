// The looks of pages; palette(":root") and drawing_style() come with it.
#pragma once

#include "draw/markup.hpp"

namespace lcpush::desktop {

constexpr const char* page_style = R"css(* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink); overflow-wrap: break-word;
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, Arial, "DejaVu Sans", sans-serif; }
header, main, footer { max-width: 1120px; margin: 0 auto; padding: 0 24px; }
header { padding-top: 24px; }
h1 { font-size: 28px; line-height: 1.2; margin: 0 0 6px; }
h2 { font-size: 20px; line-height: 1.3; margin: 34px 0 8px; }
#answer h2 { margin: 12px 0 4px; font-size: 16px; color: var(--soft); }
h3 { font-size: 17px; margin: 22px 0 6px; }
p { margin: 0 0 10px; max-width: 72ch; }
a { color: var(--normal); }
.aside { color: var(--soft); font-size: 15px; }
nav { margin-top: 24px; }
nav ul { list-style: none; display: flex; flex-wrap: wrap; gap: 4px 20px; margin: 10px 0 0;
  padding: 8px 0; border: solid var(--line); border-width: 1px 0; }
nav a { display: inline-block; padding: 4px 0; }
:focus-visible { outline: 3px solid var(--normal); outline-offset: 2px; }
.lead { font-size: 20px; line-height: 1.4; max-width: none; margin-bottom: 8px; }
.check { border-left: 5px solid var(--cone); padding: 2px 0 2px 14px; }
.verdict { border-left: 5px solid var(--move); padding: 4px 0 4px 14px; }
.failure { border: 2px solid var(--bad); background: var(--bad-wash); padding: 12px 16px;
  margin: 0 0 14px; max-width: 80ch; }
.failure p:last-child { margin-bottom: 0; }
.failure strong { color: var(--bad); }
.facts { margin: 0; max-width: 88ch; }
.facts div { display: grid; grid-template-columns: 11em minmax(0, 1fr); gap: 2px 16px;
  padding: 7px 0; border-bottom: 1px solid var(--line); }
.facts dt { color: var(--soft); }
.facts dd { margin: 0; }
figure { margin: 0 0 12px; min-width: 0; }
figcaption { color: var(--soft); font-size: 15px; padding-top: 4px; }
.views { display: grid; grid-template-columns: minmax(0, 8fr) minmax(0, 5fr); gap: 4px 24px; }
.panels { display: grid; grid-template-columns: repeat(6, minmax(0, 170px)); gap: 10px; }
.drawing, .plot { width: 100%; height: auto; display: block; border: 1px solid var(--line); }
.single .drawing { max-width: 560px; }
.key { list-style: none; margin: 10px 0; padding: 0; display: grid; gap: 3px 20px;
  grid-template-columns: repeat(auto-fill, minmax(min(100%, 265px), 1fr)); font-size: 15px; }
.key li { display: flex; gap: 10px; align-items: center; }
.key .drawing, td .drawing { border: 0; background: none; flex: none; width: 30px; height: 16px; }
td .drawing { display: inline-block; width: 14px; height: 12px; margin-right: 6px;
  vertical-align: -1px; }
.scroll { overflow-x: auto; max-width: 100%; margin: 0 0 14px; }
.scroll .plot { min-width: 620px; max-width: 860px; }
table { border-collapse: collapse; font-size: 15px; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: 4px 0 6px; }
caption span { display: block; position: sticky; left: 0; width: fit-content;
  max-width: min(72ch, calc(100vw - 48px)); }
th, td { padding: 5px 12px; text-align: right; border-bottom: 1px solid var(--line);
  white-space: nowrap; font-weight: 400; }
th:first-child { text-align: left; padding-left: 0; min-width: 6em; max-width: 22em;
  white-space: normal; overflow-wrap: anywhere; }
thead th { color: var(--soft); border-bottom-color: var(--faint); }
.words { text-align: left; }
pre { font: 13px/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; margin: 0; }
details { margin: 8px 0 14px; }
summary { cursor: pointer; padding: 8px 0; }
footer { color: var(--soft); font-size: 15px; padding-top: 26px; padding-bottom: 36px; }
@media screen and (max-width: 820px) {
  .views { grid-template-columns: minmax(0, 1fr); }
  .views .drawing { max-width: 560px; }
  .panels { grid-template-columns: repeat(auto-fill, minmax(126px, 1fr)); }
}
@media screen and (max-width: 600px) {
  header, main, footer { padding-left: 16px; padding-right: 16px; }
  h1 { font-size: 23px; }
  .lead { font-size: 18px; }
  .facts div { grid-template-columns: minmax(0, 1fr); gap: 0; }
  .facts dt { font-size: 15px; }
  table { font-size: 12.5px; }
  th, td { padding: 5px 4px; }
  thead th, .words { white-space: normal; }
  th:first-child { min-width: 5.5em; position: sticky; left: 0; background: var(--paper); }
  /* A shade at the right edge where a table goes on. */
  .scroll { background: linear-gradient(to left, var(--paper) 40%, transparent) right / 28px 100%
    no-repeat local, linear-gradient(to left, var(--line), transparent) right / 12px 100% no-repeat; }
}
@media print {
  nav, summary { display: none; }
  body { font-size: 11px; line-height: 1.35; background: none; }
  h1 { font-size: 20px; }
  h2 { break-after: avoid; font-size: 14px; margin: 10px 0 4px; }
  .lead { font-size: 14px; }
  pre, table, .key, figcaption, footer, .aside, .facts dt { font-size: 10px; }
  th, td { padding: 2px 8px; }
  .facts div { padding: 3px 0; }
  .single .drawing { max-width: 340px; }
  .views figure:first-child { margin: 0; }
  figure, table, .failure { break-inside: avoid; }
  .scroll { overflow: visible; }
  .scroll .plot { min-width: 0; }
}
)css";

/// A page that loads nothing, up to its body: `title` is escaped, `style` more than page_style;
/// `policy` allows more.
inline std::string page_head(const std::string& title, const std::string& style = "",
                             const std::string& policy = "") {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
         "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
         "data:; "
         "style-src 'unsafe-inline'" +
         policy + "\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n<title>" + title +
         "</title>\n<style>\n" + palette(":root") + drawing_style() + page_style + style +
         "</style>\n</head>\n<body>\n<header>\n<h1>" + title + "</h1>\n</header>\n<main>\n";
}

} // namespace lcpush::desktop
