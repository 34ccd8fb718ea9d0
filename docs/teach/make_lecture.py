#!/usr/bin/env python3
"""The lecture as a folder of pages that opens without a network: its text, the exercises, slides, a
handout, Beamer's slides, and every problem of the text live, at the pivot that the text is at.

    python3 docs/teach/make_lecture.py build/release/lcpush docs/teach/live

Begin with index.html. The text's links named Live lead into that folder.
"""
import base64
import html
import pathlib
import re
import shlex
import subprocess
import sys
import urllib.parse

TEACH = pathlib.Path(__file__).resolve().parent
ROOT = TEACH.parents[1]
PAGES = {"lemke_by_hand": "index", "exercises": "exercises", "galleries": "galleries",
         "lecture_plan": "lecture_plan"}
ON_THE_HANDOUT = 1, 2, 3, 5, 7, 10  # exercises


# Live: the page of a command's problem.

def read_mtx(name):
    """A Matrix Market array, as --M or --q would take it."""
    lines = [line for line in (ROOT / name).read_text().split("\n") if line and line[0] != "%"]
    rows, columns = map(int, lines[0].split())
    return "; ".join(" ".join(lines[1 + j * rows + i].strip() for j in range(columns)) for i in range(rows))


def commands(markdown):
    """(words after `lcpush pivots`, what it prints) of every such command in the text's blocks."""
    for block in re.findall(r"^```(?:console|text)\n(.*?)^```", markdown, flags=re.S | re.M):
        for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, printed = part.partition("\n")
            if "lcpush pivots " in command:
                yield shlex.split(command.split("lcpush pivots ")[1]), printed


def live(words):
    """The page's name, and what its address carries: lcp.html the problem, others only a pivot."""
    plain = [word for word in words if word not in ("--exact", "--choose", "-v")]
    if plain[0] == "--M" and len(plain) == 4:
        problem = plain[1], plain[3]
    elif len(plain) == 2 and plain[0].endswith(".mtx"):
        problem = read_mtx(plain[0]), read_mtx(plain[1]).replace(";", "")
    else:
        files = [pathlib.Path(word).name.split(".")[0] if word.endswith((".mtx", ".toml")) else word
                 for word in plain if not word.endswith(".q.mtx")]
        return re.sub(r"[^\w-]+", "_", "_".join(files)).replace("--", "") + ".html", ""
    return "lcp.html", "problem=" + "%7C".join(urllib.parse.quote(x, safe=";/") for x in problem)


def live_link(words, step, guess=False):
    page, problem = live(words)
    return f"live/{page}#{problem}{'&' if problem else ''}step={step}{'&guess' if guess else ''}"


def write_live(tool, folder):
    def ask(*words, into):
        done = subprocess.run([tool, *words, "-o", folder / into], cwd=ROOT, capture_output=True, text=True)
        if done.returncode not in (0, 1):  # 1: it ends in a ray
            sys.exit(done.stderr)
    ask("play", "--lcp", into="lcp.html")
    pages = {live(words)[0]: words for page in PAGES for words, _ in commands((TEACH / f"{page}.md").read_text())}
    for name, words in pages.items():
        if name != "lcp.html":
            ask("pivots", *(word for word in words if word not in ("--choose", "-v")), "--format", "html", into=name)


# Markdown, as far as these texts use it.

def inline(text):
    def link(match):
        words, target = match[1], match[2]
        if target.startswith("live/"):
            return f'<a class="live" href="{target[5:]}">{words}</a>'
        page, _, anchor = target.partition("#")
        name = PAGES.get(page.removesuffix(".md"), page)
        if "://" in page or (page and not page.removesuffix(".md") in PAGES and page not in PAGES.values()):
            return words if "://" not in page else f'<a href="{page}">{words}</a>'
        return f'<a href="{name + ".html" if page else ""}{"#" + anchor if anchor else ""}">{words}</a>'

    def image(match):
        data = base64.b64encode((TEACH / match[2]).read_bytes()).decode()
        return f'<img alt="{match[1]}" src="data:image/svg+xml;base64,{data}">'

    parts = re.split(r"(`[^`]+`)", html.escape(text, quote=False))
    for k, part in enumerate(parts):
        if k % 2:
            parts[k] = f"<code>{part[1:-1]}</code>"
            continue
        part = re.sub(r"\*\*(.+?)\*\*", r"<strong>\1</strong>", part)
        part = re.sub(r"(?<!\w)\*([^*\n]+?)\*(?!\w)", r"<em>\1</em>", part)
        parts[k] = part
    text = "".join(parts)
    text = re.sub(r"!\[([^]]*)\]\(([^)\s]+)\)", image, text)
    text = re.sub(r"\[([^]]*)\]\(([^)\s]+)\)", link, text)
    return "".join(part if part[:1] == "<" else as_mathematics(part)
                   for part in re.split(r"(<code>.*?</code>|<[^>]+>)", text))


def as_mathematics(text):
    """z0 and 2^n with their numbers below and above the line."""
    text = text.replace("&gt;=", "\u2265").replace("&lt;=", "\u2264")
    text = re.sub(r"\b([wzv])(\d+)\b", r"<i>\1</i><sub>\2</sub>", text)
    text = re.sub(r"\b([wza])_([ixy])\b", r"<i>\1</i><sub>\2</sub>", text)
    return re.sub(r"(?<=\w)\^(\w+)", r"<sup>\1</sup>", text)


def anchor_of(title):
    return re.sub(r"[^\w\- ]", "", re.sub(r"\[(.*?)\]\(.*?\)", r"\1", title).lower()).replace(" ", "-")


def table(lines):
    rows = [[inline(cell.strip()) for cell in line.strip().strip("|").split("|")] for line in lines]
    head = "".join(f"<th>{cell}</th>" for cell in rows[0])
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>\n" for row in rows[2:])
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead>\n<tbody>{body}</tbody></table></div>\n'


def to_html(markdown):
    out, lines = [], re.sub(r"<!--.*?-->\n?", "", markdown, flags=re.S).split("\n")
    at = 0

    def take(condition):
        nonlocal at
        first = at
        while at < len(lines) and condition(lines[at]):
            at += 1
        return lines[first:at]

    while at < len(lines):
        line = lines[at]
        if not line.strip():
            at += 1
        elif line.startswith("```"):
            at += 1
            block = take(lambda x: not x.startswith("```"))
            at += 1
            out.append(f"<pre tabindex=\"0\">{html.escape(chr(10).join(block))}</pre>\n")
        elif line.startswith("#"):
            marks, title = line.split(" ", 1)
            out.append(f'<h{len(marks)} id="{anchor_of(title)}">{inline(title)}</h{len(marks)}>\n')
            at += 1
        elif line.startswith("    "):
            block = take(lambda x: x.startswith("    ") or not x.strip())
            out.append("<pre>" + html.escape("\n".join(x[4:] for x in block).rstrip()) + "</pre>\n")
        elif line.startswith("<"):
            out.append(line + "\n")
            at += 1
        elif line.startswith("|"):
            out.append(table(take(lambda x: x.startswith("|"))))
        elif re.match(r"- |\d+\. ", line):
            kind = "ul" if line[0] == "-" else "ol"
            items = re.split(r"^(?:- |\d+\. )", "\n".join(take(lambda x: x.strip())), flags=re.M)[1:]
            out.append(f"<{kind}>" + "".join(f"<li>{inline(item)}</li>\n" for item in items) + f"</{kind}>\n")
        else:
            words = "\n".join(take(lambda x: x.strip() and not re.match(r"```|#|\||<|- ", x)))
            out.append(f"<p>{inline(words)}</p>\n")
    return "".join(out)


STYLE = """
:root { color-scheme: light dark; --paper: #fcfbf8; --ink: #1c1e21; --soft: #575c63; --line: #d8d3c8;
  --wash: #f3f0e8; --link: #1a5796; }
@media screen and (prefers-color-scheme: dark) { :root { --paper: #17181a; --ink: #e9e6df; --soft: #b3afa6;
  --line: #3b3d41; --wash: #22252a; --link: #8bbcf2; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 12px 20px 60px; max-width: 900px; background: var(--paper); color: var(--ink);
  font: 17px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, Arial, "DejaVu Sans", sans-serif; }
h1 { line-height: 1.2; } h2 { margin-top: 1.8em; }
a { color: var(--link); } a.live { font-weight: 600; }
sub, sup { line-height: 0; font-size: 0.72em; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 14px; }
pre { background: var(--wash); border: 1px solid var(--line); padding: 10px 12px; overflow-x: auto; line-height: 1.4; }
img { display: block; max-width: 100%; width: 520px; margin: 10px 0; background: #fff; }
table { border-collapse: collapse; } th, td { border: 1px solid var(--line); padding: 4px 10px; text-align: left;
  vertical-align: top; }
th { font-weight: 600; } .scroll { overflow-x: auto; }
details { border: 1px solid var(--line); padding: 4px 14px; margin: 12px 0; } summary { cursor: pointer; min-height: 34px;
  line-height: 34px; }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
nav { display: flex; flex-wrap: wrap; gap: 4px 16px; }
@media print { :root { --paper: #fff; } nav { display: none; } a { color: inherit; text-decoration: none; } body { max-width: none; } }
"""


def page(title, body, style="", script=""):
    return ("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<link rel=\"icon\" href=\"data:,\">\n"
            f"<title>{title}</title>\n<style>{STYLE}{style}</style>\n</head>\n<body>\n{body}"
            + (f"<script>{script}</script>\n" if script else "") + "</body>\n</html>\n")


NAV = ('<nav aria-label="Pages"><a href="index.html">Lecture</a><a href="exercises.html">Exercises</a>'
       '<a href="lecture_plan.html">Plan</a><a href="slides.html">Slides</a><a href="handout.html">Handout</a>'
       '<a href="lcp.html">Your own M and q</a></nav>\n')


# Slides: the plan's boards, and a slide for every pivot of the commands on them.

DECK_STYLE = """
body { margin: 0; padding: 0; max-width: none; overflow: hidden; }
.slide { width: 1280px; height: 720px; padding: 40px 72px; font-size: 34px; line-height: 1.4; overflow: hidden;
  position: absolute; transform-origin: 0 0; }
.slide:focus { outline: none; } .slide h2 { font-size: 42px; line-height: 1.15; margin: 0 0 20px; } .slide p { margin: 0 0 16px; }
.slide pre { font-size: 31px; line-height: 1.32; border: 0; margin: 0 0 16px; padding: 8px 14px; overflow: hidden; }
.slide li { margin-bottom: 10px; } .slide table { font-size: 30px; }
.slide img { width: auto; height: 540px; margin: 0 auto; }
.number { position: absolute; right: 24px; bottom: 12px; font-size: 20px; color: var(--soft); }
@page { size: 1280px 720px; margin: 0; }
@media print { body { overflow: visible; } .slide { position: relative; inset: auto !important; transform: none !important;
  break-after: page; }
  .slide:last-of-type { break-after: auto; } .slide[hidden] { display: block !important; } .slide.ask { display: none !important; } }
"""
DECK_SCRIPT = """
const slides = [...document.querySelectorAll('.slide')];
let at = 0;
function show(k) {
  at = Math.max(0, Math.min(slides.length - 1, k));
  slides.forEach((slide, i) => { slide.hidden = i !== at; });
  slides[at].focus();
  try { history.replaceState(null, '', `#${at + 1}`); } catch { /* a page in a sandbox */ }
}
function fit() {
  const scale = Math.min(innerWidth / 1280, innerHeight / 720);
  for (const { style } of slides) {
    style.transform = `scale(${scale})`;
    style.left = `${(innerWidth - 1280 * scale) / 2}px`;
    style.top = `${(innerHeight - 720 * scale) / 2}px`;
  }
}
const keys = { ArrowRight: () => show(at + 1), ' ': () => show(at + 1), PageDown: () => show(at + 1),
  ArrowLeft: () => show(at - 1), PageUp: () => show(at - 1), Home: () => show(0), End: () => show(slides.length - 1),
  f: () => (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen()) };
addEventListener('keydown', (event) => {
  if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  keys[event.key]();
});
addEventListener('click', (event) => {
  if (!event.target.closest('a')) show(at + (event.clientX < innerWidth / 3 ? -1 : 1));
});
addEventListener('hashchange', () => show(Number(location.hash.slice(1)) - 1));
addEventListener('resize', fit);
fit();
show((Number(location.hash.slice(1)) || 1) - 1);
"""


def boards():
    text = (TEACH / "lecture_plan.md").read_text()
    return re.findall(r"^### Board: (.*?)\n(.*?)(?=^##|\Z)", text, flags=re.S | re.M)


def asked(tableau):
    """A tableau without what says which row leaves: its brackets and its last column, the ratios."""
    lines = re.sub(r"\[(\S+)\]", r"  \1", tableau).split("\n")
    end = len(lines[0].removesuffix("ratio").rstrip())
    return "\n".join(line[:end] for line in lines)


def pivot_slides(tool, words):
    """(title, HTML, whether it only asks): for each pivot first the tableau, then what happens."""
    printed = subprocess.run([tool, "pivots", *words], cwd=ROOT, capture_output=True, text=True).stdout
    for part in re.split(r"\n\n(?=Pivot |Solved|Not solved)", printed)[1:]:
        title, _, rest = part.partition("\n")
        found = re.search(r"^ {4,}value.*", rest, flags=re.S | re.M)
        said, tableau = (rest[:found.start()], found[0].rstrip()) if found else (rest, "")
        if title.startswith("Pivot"):
            entering = title.split(" enters")[0]
            yield f"{entering} enters. Which row leaves?", f"<pre>{html.escape(asked(tableau))}</pre>\n", True
            words_said = "".join(f"<p>{inline(' '.join(words.split()))}</p>\n"
                                 for words in re.match(r"(  tied: [^\n]*\n)?(.*)", said, flags=re.S).groups() if words)
            yield title.split(";")[0], f"<pre>{html.escape(tableau)}</pre>\n{words_said}", False
        else:
            yield title, f"<pre>{html.escape(said.rstrip())}\n\n{html.escape(tableau)}</pre>\n", False


def write_slides(tool, folder):
    slides = [("Lemke\u2019s method by hand", "<p>Arrow keys; F for the full screen.</p>\n", False)]
    for title, text in boards():
        runs = list(commands(text))
        if runs:
            slides += pivot_slides(tool, runs[0][0])
        else:
            slides.append((title, to_html(text), False))
    body = "".join(f'<section class="slide{" ask" if asks else ""}" tabindex="-1" '
                   f'aria-label="Slide {k} of {len(slides)}">'
                   f"<h2>{inline(title)}</h2>\n{content}<p class=\"number\">{k}</p></section>\n"
                   for k, (title, content, asks) in enumerate(slides, 1))
    (folder / "slides.html").write_text(page("Lemke\u2019s method by hand: slides", body, DECK_STYLE, DECK_SCRIPT))


def write_beamer(tool, folder):
    """A frame for every pivot of the commands on the boards, and for how each ends."""
    frames = []
    for title, text in boards():
        for words, _ in commands(text):
            printed = subprocess.run([tool, "pivots", *words, "--format", "latex"], cwd=ROOT, capture_output=True,
                                     text=True).stdout
            frames += [f"\\begin{{frame}}{{{title}}}\n\\small\n\\noindent {part.strip()}\n\\end{{frame}}\n"
                       for part in printed.split("\\noindent ")[1:]]
    head = ("\\documentclass{beamer}\n\\usepackage{amsmath}\n\\setbeamertemplate{navigation symbols}{}\n"
            "\\title{Lemke's method by hand}\n\\date{}\n\\begin{document}\n\\frame{\\titlepage}\n\n")
    (folder / "beamer.tex").write_text(head + "\n".join(frames) + "\\end{document}\n")


HANDOUT_STYLE = """
.sheet h2 { margin-top: 0.6em; } .sheet h3 { margin-bottom: 0; } .sheet img { width: 330px; }
@page { size: A4; margin: 15mm 17mm; }
@media print { body { padding: 0; font-size: 10.5pt; line-height: 1.38; } .sheet + .sheet { break-before: page; }
  p, ul, ol, pre { margin: 0 0 7px; } pre, code { font-size: 9pt; } .sheet img { width: 62mm; margin: 4px auto; } }
"""


def write_handout(folder):
    method = (TEACH / "lecture_plan.md").read_text().split("\n## The method on one page\n")[1]
    exercises = re.split(r"^## (?=Exercise \d+: )", (TEACH / "exercises.md").read_text(), flags=re.M)[1:]
    chosen = [re.sub(r"^Live: .*\n", "", text.split("<details>")[0], flags=re.M) for text in exercises
              if int(text.split(":")[0].split(" ")[1]) in ON_THE_HANDOUT]
    sheets = "## Lemke's method on one page\n" + method, "## Exercises\n\n" + "".join("### " + text for text in chosen)
    body = "".join(f'<section class="sheet">{to_html(sheet)}</section>\n' for sheet in sheets)
    (folder / "handout.html").write_text(page("Lemke\u2019s method by hand: handout", NAV + body, HANDOUT_STYLE))


def write_text(folder):
    for source, name in PAGES.items():
        text = (TEACH / f"{source}.md").read_text()
        title = re.search(r"^# (.*)$", text, flags=re.M)[1]
        (folder / f"{name}.html").write_text(page(title, NAV + f"<main>{to_html(text)}</main>\n"))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    target = pathlib.Path(sys.argv[2])
    target.mkdir(parents=True, exist_ok=True)
    lcpush = pathlib.Path(sys.argv[1]).resolve()
    write_live(lcpush, target.resolve())
    write_text(target)
    write_slides(lcpush, target)
    write_beamer(lcpush, target)
    write_handout(target)
    print(f"Wrote {target / 'index.html'} and what it leads to; open it in a browser.")
