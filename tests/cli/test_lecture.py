"""The plan for 90 minutes, and what docs/teach/make_lecture.py makes of it and of the lecture: slides, a
handout, LaTeX that compiles without a warning where there is a pdflatex. tests/browser/lecture.mjs opens them."""
import html
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tool import SOURCE, TOOL, main

sys.path.insert(0, str(SOURCE / "docs/teach"))
import make_lecture  # noqa: E402

PLAN = (SOURCE / "docs/teach/lecture_plan.md").read_text()
RUNS = (["--M", "2 1; 1 2", "--q", "-5 -6", "--exact"], ["fixtures/scenes/squeeze.toml", "--exact"],
        ["fixtures/textbook/kostreva_1.M.mtx", "fixtures/textbook/kostreva_1.q.mtx", "--exact", "--first-row"],
        ["--M", "-1", "--q", "-1e-9"], ["fixtures/rays/coin_jammed.toml"])


def tex(words):
    return subprocess.run([TOOL, "pivots", *words, "--format", "latex"], cwd=SOURCE, capture_output=True, text=True).stdout


class Plan(unittest.TestCase):
    def test_the_minutes_follow_each_other_and_are_90(self):
        blocks = re.findall(r"^## (\d):(\d\d) (.*), (\d+) minutes$", PLAN, flags=re.M)
        now = 0
        for hours, minutes, name, length in blocks:
            self.assertEqual(60 * int(hours) + int(minutes), now, name)
            self.assertIn(f"| {hours}:{minutes} | {length} |", PLAN)
            now += int(length)
        self.assertEqual(now, 90)

    def test_every_block_asks_warns_and_has_a_board(self):
        for block in re.split(r"^## (?=\d:)", PLAN.split("## The method")[0], flags=re.M)[1:]:
            for part in ("**Ask.**", "### Board: ") + (() if block.startswith("1:26") else ("**Goes wrong.**",)):
                self.assertIn(part, block)

    def test_its_live_pages_are_those_of_the_lecture(self):
        known, found = (set(re.findall(r"\((live/[^)\s]*?step=)", text)) for text in (
            "".join((SOURCE / f"docs/teach/{page}.md").read_text() for page in ("lemke_by_hand", "exercises")), PLAN))
        self.assertTrue(len(found) > 4 and found <= known, found - known)


class Folder(unittest.TestCase):
    folder = tempfile.TemporaryDirectory()
    path = Path(folder.name)
    subprocess.run([sys.executable, SOURCE / "docs/teach/make_lecture.py", TOOL, path], check=True, capture_output=True)

    def test_no_page_leads_nowhere_or_asks_a_network(self):
        for page in sorted(self.path.glob("*.html")):
            text = page.read_text()
            for target in re.findall(r'(?:href|src)="([^"#]+)', text):
                if not target.startswith(("data:", "http")):
                    self.assertTrue((self.path / html.unescape(target)).exists(), (page.name, target))
            text = re.sub(r'(id="solver">).*?<', r"\1<", text, flags=re.S)  # packed: any letters
            self.assertNotRegex(text, r'src="(?!data:)|@import|url\((?!data:)')

    def test_the_slides_are_the_boards_and_each_pivot_asked_and_told(self):
        deck = (self.path / "slides.html").read_text()
        pivots = 3 + 4 + 5  # of three runs, each with a slide for its end
        self.assertEqual(deck.count("<section"), 1 + len(make_lecture.boards()) + 2 * pivots)
        self.assertEqual(deck.count('class="slide ask"'), pivots)
        for question in re.findall(r'class="slide ask".*?</section>', deck, flags=re.S):
            self.assertNotRegex(question.split("<pre>")[1], r"\[|leaves|ratio")

    def test_latex_says_variables_and_comparisons_in_mathematics(self):
        for words in RUNS:
            outside = re.sub(r"^%.*|\\\[.*?\\\]|\$.*?\$", "", tex(words), flags=re.S | re.M)
            self.assertNotRegex(outside, r"[<>|]|\b[wz]\d")
        self.assertIn(r"\cdot 10^{-9}", tex(RUNS[3]))

    @unittest.skipUnless(shutil.which("pdflatex"), "no pdflatex")
    def test_latex_compiles_without_a_warning(self):
        article = "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n%s\\end{document}\n"
        (self.path / "article.tex").write_text(article % "".join(map(tex, RUNS)))
        found = subprocess.run(["kpsewhich", "beamer.cls", "pgfmath.sty"], capture_output=True, text=True).stdout
        for name in ("article", "beamer")[:1 + (found.count("\n") == 2)]:
            for _ in range(2):
                subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", name], cwd=self.path, check=True,
                               capture_output=True)
            log = (self.path / f"{name}.log").read_text(errors="replace")
            self.assertNotRegex(log, r"(?m)^(Over|Under)full|Warning", name)


if __name__ == "__main__":
    main()
