#!/usr/bin/env python3
"""Makes the man page of a program from what it prints with --help.

usage: make_man_page.py PROGRAM --version VERSION -o PAGE
       make_man_page.py PROGRAM --check PAGE      whether the page has each option and word of the help

The help begins with "usage:" and a description. Options are indented by two blanks, what they mean is two blanks or
more behind them and goes on, indented as much, in the lines below; what is indented more is to stay as it is. A line
without indentation above options is the heading of a group, if it has a colon, and the text about that; other lines
without indentation are notes, but for those from "exit status:" on.
"""
import argparse
import os
import re
import subprocess
import sys


def help_of(program):
    return subprocess.run([program, "--help"], check=True, stdout=subprocess.PIPE, text=True).stdout


def words_of(text):
    """Without a distinction of capital letters, which the page has more of."""
    return set(re.findall(r"[\w@-]+", text.lower()))


def capital(text):
    return text[:1].upper() + text[1:]


def small(text):
    return text[:1].lower() + text[1:]


def escape(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return re.sub(r"^([.'])", r"\\&\1", text)


def paragraphs(lines):
    """Lists of lines of the same kind: options with their meaning, or text without indentation."""
    for line in lines:
        if line.strip():
            yield ("option" if re.match(r" {1,4}-", line) else "more" if line.startswith(" ") else "text"), line


class Page:
    def __init__(self, name, version, text):
        self.name, self.version, self.lines = name, version, text.rstrip("\n").split("\n")
        self.page, self.is_literal, self.column = [], False, 0

    def make(self):
        usage = re.sub(r"^usage: *", "", self.lines[0], flags=re.I)
        blocks = self.blocks()
        description = blocks.pop(0)[1] if blocks and blocks[0][0] == "text" else [self.name + "."]
        description, heading = self.without_heading(description, blocks)
        sentence = re.split(r"\.(?: |$)", " ".join(description))[0]
        self.page += ['.TH %s 1 "" "Boundary_recovery_3 %s" "User Commands"' % (self.name.upper(), self.version),
                      ".SH NAME", "%s \\- %s" % (escape(self.name), escape(small(sentence))),
                      ".SH SYNOPSIS", ".B " + escape(usage), ".SH DESCRIPTION", *map(escape, description),
                      ".SH OPTIONS"]
        if heading:
            self.add_group(heading)
        for i, (kind, lines) in enumerate(blocks):
            if kind == "options":
                self.add_options(lines)
            elif i + 1 < len(blocks):
                self.add_group(lines)
            else:
                self.add_notes(lines)
        return "\n".join(self.page) + "\n"

    def blocks(self):
        """Alternately lines without indentation, and options."""
        blocks = []
        for kind, line in paragraphs(self.lines[1:]):
            kind = "text" if kind == "text" else "options"
            if not blocks or blocks[-1][0] != kind:
                blocks.append((kind, []))
            blocks[-1][1].append(line)
        return blocks

    @staticmethod
    def without_heading(description, blocks):
        """The description, and the lines at its end that are about the first group of options."""
        for i, line in enumerate(description):
            if re.match(r"[a-z][\w ,]*:", line) and blocks:
                return description[:i], description[i:]
        return description, []

    def add_group(self, lines):
        heading = re.match(r"(\w[\w ,]*): *(.*)$", lines[0])
        if heading:
            self.page += [".SS " + escape(capital(heading.group(1)))]
            lines = [heading.group(2)] * bool(heading.group(2)) + lines[1:]
        else:
            self.page += [".PP"]
        self.page += [escape(line if i else capital(line)) for i, line in enumerate(lines)]

    def add_options(self, lines):
        for line in lines:
            if re.match(r" {1,4}-", line):
                self.end_literal()
                option, blanks, meaning = re.match(r" *(\S+(?: \S+)*)( *)(.*)$", line).groups()
                self.column = line.index(meaning, len(option)) if meaning else 0
                self.page += [".TP", ".B " + escape(option)] + [escape(meaning)] * bool(meaning)
            else:
                self.add_meaning(line)
        self.end_literal()

    def add_meaning(self, line):
        indentation = len(line) - len(line.lstrip())
        self.column = self.column or indentation
        if indentation > self.column and not self.is_literal:
            self.page += [".nf"]
            self.is_literal = True
        elif indentation <= self.column:
            self.end_literal()
        self.page += [escape(line[self.column:] if self.is_literal else line.strip())]

    def end_literal(self):
        if self.is_literal:
            self.page += [".fi"]
        self.is_literal = False

    def add_notes(self, lines):
        for i, line in enumerate(lines):
            status = re.match(r"exit status: *(.*)$", line, flags=re.I)
            if status:
                self.page += [".SH EXIT STATUS", escape(capital(status.group(1)))]
            elif i == 0:
                self.page += [".SH NOTES", escape(line)]
            else:
                self.page += [escape(line)]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("program")
    parser.add_argument("--version", default="")
    parser.add_argument("-o", dest="output")
    parser.add_argument("--check")
    arguments = parser.parse_args()
    text = help_of(arguments.program)
    if arguments.check:
        with open(arguments.check, encoding="utf-8") as file:
            missing = words_of(text) - words_of(file.read().replace("\\-", "-")) - {"usage"}
        print("not in the page: " + ", ".join(sorted(missing)) if missing else "the page has all of the help")
        return 1 if missing else 0
    page = Page(os.path.basename(arguments.program), arguments.version, text).make()
    with open(arguments.output, "w", encoding="utf-8") as file:
        file.write(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
