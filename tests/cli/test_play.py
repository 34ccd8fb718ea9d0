"""lcpush play: one page that carries the solver and the scene, and a gallery of the shipped scenes."""
import html
import pathlib
import re
import tempfile
import unittest
import urllib.parse

import tool
from tool import SCENES, command, main, unwrapped

run = command("play")


def scene_of(page):
    return html.unescape(re.search(r'id="scene">(.*?)</script>', page, re.DOTALL).group(1))


class Play(unittest.TestCase):
    def test_the_page_carries_its_scene_and_needs_nothing_else(self):
        for name in ("pivot", "jam", "rolling"):
            path = SCENES / f"{name}.toml"
            result = run(path)
            self.assertEqual((result.returncode, "Check:" in result.stderr), (0, False))
            self.assertEqual(scene_of(result.stdout), path.read_text(encoding="utf-8"))
            for address in re.findall(r"(?:src|href)=\"([^\"]*)\"", result.stdout):
                self.assertTrue(address.startswith("data:"), address)
            for place in ("STYLE", "SCRIPT", "SOLVER", "SCENE"):
                self.assertFalse(f"/*{place}*/" in result.stdout, place)
            for place in ("LOOKS", "DRAWING"):  # the page's script names what the explorer leaves open
                self.assertEqual(result.stdout.count(f"/*{place}*/"), 1, place)

    def test_no_scene_makes_a_page_of_more_than_420_kB(self):
        paths = sorted(SCENES.glob("*.toml"))
        self.assertGreater(len(paths), 15)
        for path in paths:
            self.assertLessEqual(len(run(path).stdout.encode()), 420_000, path)

    def test_without_a_scene_it_begins_with_the_straight_slide(self):
        self.assertEqual(scene_of(run().stdout),
                         (SCENES / "straight_slide.toml").read_text(encoding="utf-8"))

    def test_a_scene_cannot_leave_its_place_in_the_page(self):
        text = (SCENES / "pivot.toml").read_text(encoding="utf-8").replace(
            'title = "', 'title = "</script><script>alert(1)</script> /*SOLVER*/ ')
        page = run("-", text=text).stdout
        self.assertEqual(scene_of(page), text)
        self.assertEqual(page.count("<script"), 4)

    def test_what_is_no_scene_is_refused_with_its_line(self):
        result = run("-", text="[object]\nmass = -1\n")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, r":\d+: .*(mass|missing)")

    def test_what_the_page_would_not_solve_is_refused(self):
        text = (SCENES / "pivot.toml").read_text(encoding="utf-8").replace("points = 2", "points = 400")
        result = run("-", text=text)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("fewer points", unwrapped(result.stderr))

    def test_the_gallery_leads_to_every_shipped_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(run("--gallery", "-o", folder).returncode, 0)
            index = (pathlib.Path(folder) / "index.html").read_text(encoding="utf-8")
            links = re.findall(r'href="(play\.html)#text=([^"]*)"', index)
            texts = {urllib.parse.unquote(text) for _, text in links}
            self.assertEqual(texts, {path.read_text(encoding="utf-8") for path in SCENES.glob("*.toml")})
            for path in SCENES.glob("*.toml"):
                picture = (pathlib.Path(folder) / f"{path.stem}.svg").read_text(encoding="utf-8")
                self.assertTrue(picture.startswith("<svg"), path.stem)
            sentence = tool.run("solve", SCENES / "pivot.toml").stdout.split("\n\n")[1]
            self.assertIn(html.escape(unwrapped(sentence)), index)

    def test_a_gallery_is_a_folder_and_takes_no_scene(self):
        for words, said in ((["--gallery"], "-o DIRECTORY"),
                            (["--gallery", SCENES / "pivot.toml", "-o", "x"], "leave the scene out")):
            result = run(*words)
            self.assertEqual(result.returncode, 2)
            self.assertIn(said, unwrapped(result.stderr))


main()
