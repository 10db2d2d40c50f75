"""README.md, CHANGELOG.md and docs/*.md agree with the sources and the program.

usage: documents_test.py PROGRAM [unittest arguments]
"""
import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = None
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
README = os.path.join(ROOT, "README.md")
PAGES = sorted(glob.glob(os.path.join(ROOT, "docs", "*.md")))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def without_code(text):
    text = re.sub(r"^```.*?^```$", "", text, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"^    .*$", "", text, flags=re.MULTILINE)


def links(text):
    """Targets of [text](target) and ![text](target) that are not on the web."""
    return [target for target in re.findall(r"\]\(([^)\s]+)\)", without_code(text)) if "://" not in target]


def anchors(text):
    """The anchors of a page's headings, as GitHub makes them."""
    titles = re.findall(r"^#+ (.*)$", without_code(text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def missing_links(path):
    """Links of a file that lead to no file or to no heading of it."""
    missing = []
    for link in links(read(path)):
        name, _, anchor = link.partition("#")
        target = os.path.normpath(os.path.join(os.path.dirname(path), name)) if name else path
        if not os.path.exists(target) or (anchor and anchor not in anchors(read(target))):
            missing.append(link)
    return missing


def exists(name):
    """Whether a name is a file, a folder, or a pair of .hpp and .cpp; "src/" may be left out."""
    paths = [os.path.join(ROOT, folder, name) for folder in ("src", "")]
    return any(os.path.exists(path + suffix) for path in paths for suffix in ("", ".cpp", ".hpp"))


def named_paths(text):
    """Paths of the repository in backquotes: `core/mesh`, `tests/long`, `bench/orders.cpp`."""
    folders = "core|gui|src|tests|bench|scripts|cmake|assets|shaders|examples|packaging|docs"
    return re.findall(r"`((?:%s)/[\w./-]*\w)`" % folders, without_code(text))


def shell_lines(path):
    """What a reader can type: the lines of ```sh blocks."""
    blocks = re.findall(r"^```sh\n(.*?)^```$", read(path), re.DOTALL | re.MULTILINE)
    return [line for block in blocks for line in block.splitlines() if line.strip()]


class Text(unittest.TestCase):
    def test_the_readme_is_short(self):
        self.assertLessEqual(len(read(README).splitlines()), 150)

    def test_every_link_leads_somewhere(self):
        for path in [README, os.path.join(ROOT, "CHANGELOG.md"), *PAGES]:
            self.assertEqual(missing_links(path), [], path)

    def test_missing_files_and_headings_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "page.md")
            with open(page, "w") as file:
                file.write("# One title\n[a](page.md#one-title) [b](#two) [c](none.md) [d](https://e.org)\n"
                           "    [e](f.md)\n")
            self.assertEqual(missing_links(page), ["#two", "none.md"])

    def test_the_readme_links_every_page(self):
        linked = {os.path.normpath(os.path.join(ROOT, link)) for link in links(read(README))}
        self.assertEqual([page for page in PAGES if page not in linked], [])

    def test_every_image_is_shown(self):
        shown = {os.path.normpath(os.path.join(os.path.dirname(path), link))
                 for path in [README, *PAGES] for link in links(read(path))}
        images = [path for kind in ("png", "gif")
                  for path in glob.glob(os.path.join(ROOT, "docs", "*." + kind))]
        self.assertGreater(len(images), 3)
        self.assertEqual([image for image in images if image not in shown], [])

    def test_every_path_exists(self):
        named = 0
        for path in [README, *PAGES]:
            names = named_paths(read(path))
            named += len(names)
            self.assertEqual([name for name in names if not exists(name)], [], path)
        self.assertGreater(named, 60)
        self.assertFalse(exists("core/mesh/no_such_file.hpp"))

    def test_every_label_is_in_the_program(self):
        """Bold words of the pages for users are labels: of a row, an action, a panel or a scenario."""
        sources = "".join(read(path) for pattern in ("src/**/*.cpp", "assets/scenarios/*.toml")
                          for path in glob.glob(os.path.join(ROOT, pattern), recursive=True))
        for path in (README, os.path.join(ROOT, "docs", "window.md")):
            labels = re.findall(r"\*\*(.+?)\*\*", read(path).replace("\n   ", " ").replace("\n", " "))
            self.assertGreater(len(labels), 3, path)
            self.assertEqual([label for label in labels if '"' + label + '"' not in sources], [], path)


class Examples(unittest.TestCase):
    """Runs the shell examples of each page, in order, in an empty folder."""

    def run_lines(self, path):
        lines = shell_lines(path)
        environment = dict(os.environ, PATH=os.path.dirname(PROGRAM) + ":" + os.environ["PATH"])
        with tempfile.TemporaryDirectory() as folder:
            for line in lines:
                done = subprocess.run(line, shell=True, cwd=folder, env=environment, capture_output=True,
                                      text=True, timeout=120)
                self.assertEqual(done.returncode, 0, path + ": " + line + "\n" + done.stderr)
        return len(lines)

    def test_those_of_the_readme(self):
        self.assertGreater(self.run_lines(README), 5)

    def test_those_of_the_pages(self):
        self.assertGreater(sum(self.run_lines(path) for path in PAGES), 9)


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
