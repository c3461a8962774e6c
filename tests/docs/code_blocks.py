# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""Code in the pages of docs/ and in README.md: programs with a title compile and run, others compile, paths in commands
exist, diffs apply. code_blocks.py BUILD CC CXX, from the root of the tree."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w+)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SNIPPET = re.compile(r'^--8<-- "([^"]+)"$', re.MULTILINE)
PATH = re.compile(r"(?<![\w/.-])((?:scripts|examples|python|docs|build/release/examples|tests)/[\w./*-]*\w)")
PART = "#include \"RCFramework.h\"\nvoid part() {\n%s\n}\n"


class Checker:
    def __init__(self, build, cc, cxx, scratch):
        self.build, self.scratch = pathlib.Path(build), pathlib.Path(scratch)
        self.compilers = {"c": [cc, "-std=c99"], "cpp": [cxx, "-std=c++20"]}
        self.environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        self.environment.update(RAYCORE_FRAMES="2", RAYCORE_LOG="error", PYTHONPATH=str(self.build / "python"),
                                LD_LIBRARY_PATH=str(self.build / "src/egl"))
        self.count = 0

    def run(self, command, **more):
        done = subprocess.run(command, capture_output=True, text=True, env=self.environment, cwd=self.scratch,
                              timeout=120, **more)
        output = done.stdout + done.stderr
        return output if done.returncode or ": RC_" in output else ""

    def program(self, language, text):
        source = self.scratch / f"block.{language}"
        whole = "main(" in text or "RCFramework {" in text or "public RCFramework" in text
        source.write_text(text if whole or language == "c" else PART % text)
        root = pathlib.Path.cwd()
        flags = [f"-I{root}/include", f"-I{root}/examples"]
        if not whole:
            return self.run(self.compilers[language] + ["-Wall", "-Wextra", "-fsyntax-only", source] + flags)
        libraries = [f"-L{self.build}/src/framework", f"-L{self.build}/src/egl", "-lRCFramework", "-lRayCoreAPI",
                     "-lX11"]
        return (self.run(self.compilers[language] + ["-Wall", "-Wextra", source, "-o", "program"] + flags + libraries)
                or self.run([self.scratch / "program"]))

    def python(self, text):
        if not list((self.build / "python/raycore").glob("_core*.so")):
            return ""  # the package is left out of this build
        (self.scratch / "block.py").write_text(text)
        return self.run(["/usr/bin/python3", "block.py"])

    def shell(self, text):
        wrong = subprocess.run(["bash", "-n"], input=text, capture_output=True, text=True).stderr
        for path in PATH.findall(text):
            found = path.replace("build/release", str(self.build), 1) if path.startswith("build/") else path
            if not list(pathlib.Path("/" if found.startswith("/") else ".").glob(found.lstrip("/"))):
                wrong += f"{path} does not exist\n"
        return wrong

    def diff(self, files):
        wrong = ""
        for file in files:
            if "port" in file:  # of a renamed file that is not in the tree: scripts/book_parts.sh --check
                continue
            if "entry_point" in file:
                wrong += self.diff_of_the_past(pathlib.Path(file).read_text())
                continue
            done = subprocess.run(["patch", "-p1", "--dry-run", "--force", "-i", file], capture_output=True, text=True)
            wrong += done.stdout if done.returncode else ""
        return wrong

    def diff_of_the_past(self, text):
        """What it added is still there, whatever came around it and however it is broken into lines."""
        wrong = ""
        for part in re.split(r"^--- .*\n", text, flags=re.MULTILINE)[1:]:
            name = re.match(r"\+\+\+ b/(.*)", part).group(1)
            squeezed = re.sub(r"\s", "", pathlib.Path(name).read_text())
            for line in re.findall(r"^\+(?!\+\+)(.*)$", part, re.MULTILINE):
                if "kExtensions" not in line and "RC_RCX_" not in line and re.sub(r"\s", "", line) not in squeezed:
                    wrong += f"{name} has no line: {line}\n"
        return wrong

    def check(self, language, title, text):
        snippets = SNIPPET.findall(text)
        missing = [file for file in snippets if not pathlib.Path(file).exists()]
        if missing:
            return f"{missing} not found"
        self.count += 1
        if language == "diff":
            return self.diff(snippets)
        if snippets:
            return ""  # examples are built and run by themselves
        if language in self.compilers:
            return self.program(language, text)
        if language == "python":
            return self.python(text)
        return self.shell(text) if language == "sh" else ""


def main(build, cc, cxx):
    failed = False
    with tempfile.TemporaryDirectory() as scratch:
        checker = Checker(build, cc, cxx, scratch)
        for page in [pathlib.Path("README.md"), *sorted(pathlib.Path("docs").rglob("*.md"))]:
            if "extensions" in page.parts:  # tests/docs/extensions.sh
                continue
            for language, title, text in BLOCK.findall(page.read_text(encoding="utf-8")):
                wrong = checker.check(language, title, text)
                if wrong:
                    failed = True
                    print(f"{page}: ```{language}{title}\n{wrong}")
        print(f"{checker.count} blocks of code")
        return failed or checker.count < 30


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]))
