"""Checks the pages that Doxygen has made: no dead link, no missing picture, no command or formula that is shown raw.

usage: check_manual.py FOLDER               exit 1 if anything is wrong in the pages in FOLDER
       check_manual.py --self-test SCRATCH  exit 1 unless defects that are put into pages are found

Links to other places than the folder are not followed, so no network is needed. Only Python's standard library is used.
"""
import html.parser
import os
import re
import shutil
import sys
import urllib.parse

LINKS = {"a": "href", "link": "href", "area": "href", "img": "src", "script": "src", "iframe": "src", "object": "data"}
WITHOUT_END = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "param", "source", "wbr"}
# Commands of Doxygen and of CGAL, and what begins a formula in the source.
RAW = re.compile(r"\\(f\$|f\[|f\]|cgal[A-Z]\w*|(?:sub)*section|subpage|page|ref|anchor|snippet|include|image|brief|param|return)(?!\w)")


class Page(html.parser.HTMLParser):
    """What a page links to, the places in it that can be linked to, and what of its text looks like a command."""
    def __init__(self, text):
        super().__init__()
        self.links, self.places, self.raw = [], set(), []
        self.tags = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(attributes[name] for name in ("id", "name") if attributes.get(name))
        if attributes.get(LINKS.get(tag)):
            self.links.append(attributes[LINKS[tag]])
        if tag not in WITHOUT_END:
            self.tags.append((tag, tag in ("script", "style", "pre") or attributes.get("class") == "fragment"))

    def handle_endtag(self, tag):
        while self.tags and any(t == tag for t, _ in self.tags):
            if self.tags.pop()[0] == tag:
                break

    def handle_data(self, text):
        if not any(is_code for _, is_code in self.tags):
            self.raw += [m.group(0) for m in RAW.finditer(text)]


def complaints_about(folder):
    pages = {}
    for path, _, names in os.walk(folder):
        for name in names:
            if name.endswith(".html") and "mathjax" not in path:
                file = os.path.join(path, name)
                with open(file, encoding="utf-8") as f:
                    pages[os.path.normpath(file)] = Page(f.read())
    complaints = [] if pages else ["%s: no pages" % folder]
    number_of_links = 0
    for path, page in sorted(pages.items()):
        complaints += ["%s: shows %s" % (path, raw) for raw in page.raw]
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            number_of_links += 1
            target = os.path.normpath(os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path))) if parts.path else path
            place = urllib.parse.unquote(parts.fragment)
            if not os.path.exists(target):
                complaints.append("%s: %s is not there" % (path, link))
            elif place and target in pages and place not in pages[target].places:
                complaints.append("%s: %s has no place %s" % (path, target, place))
    for url in menu_links(folder):
        if not os.path.exists(os.path.join(folder, url.partition("#")[0])):
            complaints.append("menudata.js: %s is not there" % url)
    return complaints, len(pages), number_of_links


def menu_links(folder):
    """Doxygen's menu is made by a script."""
    path = os.path.join(folder, "menudata.js")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return re.findall(r'url:"([^":]+)"', file.read())


def self_test(scratch):
    good = {"index.html": '<a href="second.html#here">x</a><img src="picture.svg"><object data="picture.svg"></object>'
                          '<a href="https://www.cgal.org/nothing">y</a><pre>\\ref x</pre><p>C:\\temp</p>',
            "second.html": '<br><h1 id="here">z</h1><a href="#here">w</a><a href="index.html">v</a>', "picture.svg": "<svg/>",
            "menudata.js": 'var m={text:"Main",url:"index.html"}'}
    defects = {"": ("index.html", "", ""), "lost.html#here is not there": ("index.html", "second.html", "lost.html"),
               "has no place there": ("index.html", "#here", "#there"),
               "lost.svg is not there": ("index.html", 'src="picture', 'src="lost'),
               "gone.svg is not there": ("index.html", 'data="picture', 'data="gone'),
               "shows \\f$": ("second.html", "z</h1>", "z \\f$ x \\f$</h1>"),
               "shows \\cgalCite": ("second.html", "z</h1>", "z \\cgalCite{CZZ+17}</h1>"),
               "menudata.js: gone.html": ("menudata.js", "index.html", "gone.html")}
    wrong = []
    for expected, (name, old, new) in defects.items():
        shutil.rmtree(scratch, ignore_errors=True)
        os.makedirs(scratch)
        for file_name, text in good.items():
            with open(os.path.join(scratch, file_name), "w", encoding="utf-8") as file:
                file.write(text.replace(old, new, 1) if file_name == name and old else text)
        complaints = complaints_about(scratch)[0]
        if not (any(expected in c for c in complaints) if expected else not complaints):
            wrong.append("expected '%s', and there was %s" % (expected, complaints))
    shutil.rmtree(scratch, ignore_errors=True)
    print("%d cases tried" % len(defects))
    return wrong


def main(arguments):
    if len(arguments) == 2 and arguments[0] == "--self-test":
        complaints = self_test(arguments[1])
    elif len(arguments) == 1:
        complaints, number_of_pages, number_of_links = complaints_about(arguments[0])
        print("%d pages, %d links" % (number_of_pages, number_of_links))
    else:
        print(__doc__)
        return 1
    print("\n".join(complaints) if complaints else "nothing to complain about")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
