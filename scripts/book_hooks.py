# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The raycore authors
"""What MkDocs does besides: programs in pages lose their licence lines, and lists need no empty line before them."""
import re

LIST = re.compile(r"^(?!\s*(?:[-*|>]|\d+\.)\s)(\S[^\n]*)\n(?=(?:[-*]|\d+\.) )", re.MULTILINE)


def on_page_markdown(markdown, page, config, files):
    parts = re.split(r"(^```.*?^```$)", markdown, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if part.startswith("```") else LIST.sub(r"\1\n\n", part) for part in parts)


def on_page_content(html, page, config, files):
    """The two comment lines, and the empty one after them, come as highlighted spans."""
    line = r'<span class="c[1p]?">(?://|#) SPDX-[^<]*</span>\s*'
    return re.sub(f'(?:{line})+(?:<span class="c1">//</span>\\s*)?', "", html)
