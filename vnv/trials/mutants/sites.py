"""Where a source file can be mutated, and into what: found in the text of one line at a time.

The operators are those of mutation testing (Jia & Harman 2011): an arithmetic, relational or logical operator becomes
another, a constant is changed, a maximum becomes a minimum, a statement is dropped. Comments, words between quotes, declarations of
types, preprocessor lines and what the compiler alone evaluates are left as they are.
"""

import dataclasses
import re

import seeded

OPERATORS = {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "<": "<=", "<=": "<",
             ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&"}
WORDS = {"true": "false", "false": "true", "min": "max", "max": "min", "sin": "cos", "cos": "sin", "front": "back", "back": "front"}
PASSED_OVER = re.compile(r"\s*(#|//|\*|static_assert|template\b|using\b|namespace\b|concept\b|requires\b|struct\b|class\b|enum\b|friend\b|case\b|default:|}?\s*$)")
OPERATOR = re.compile(r"(?<= )(" + "|".join(re.escape(sign) for sign in sorted(OPERATORS, key=len, reverse=True)) + r")(?= )")
WORD = re.compile(r"(?<![\w.>])(?:std::)?(true|false|min|max|sin|cos)\b(?=[(,;) ]|$)|(?<=\.)(front|back)(?=\(\))")
NUMBER = re.compile(r"(?<![\w.<'])(\d+\.?\d*(?:e[+-]?\d+)?|\.\d+)(?![\w.>'])")
NOT = re.compile(r"(?<![\w)])!(?=[\w(])(?!=)")
STATEMENT = re.compile(r"\s+(?!return\b|throw\b|break\b|continue\b|using\b|const\b|constexpr\b|static\b|auto\b|goto\b|delete\b|if\b|for\b|while\b|else\b|case\b)"
                       r"([\w.:\[\]()*>-]+(?:\[.*\])?\s[-+*/|&]?=\s.*|[\w.:>-]+\(.*\)|\+\+.*);$")


@dataclasses.dataclass(frozen=True)
class Site:
    file: str
    number: int  # of the line, from 1
    line: str  # as it stands, without what surrounds it
    becomes: str
    kind: str

    def as_fault(self, root):
        """The whole file before and after, since a line may stand in it more than once."""
        before = (root / self.file).read_text(encoding="utf-8")
        lines = before.splitlines(keepends=True)
        lines[self.number - 1] = lines[self.number - 1].replace(self.line, self.becomes or ";")
        return seeded.Fault(self.file, self.kind, False, (), (seeded.Change(self.file, before, "".join(lines), self.number),))


def code_of(line):
    """The line with blanks for comments and for what is between quotes."""
    blank = lambda found: " " * len(found[0])
    return re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'|//.*$|/\*.*?\*/', blank, line)


def changed_number(text):
    """An integer grows by one; a real number is doubled, and nought becomes one."""
    if re.fullmatch(r"\d+", text):
        return str(int(text) + 1)
    value = float(text)
    return repr(2 * value) if value else "1.0"


def sites_of_line(line):
    """Pairs of the line as it becomes and of the kind of mutation."""
    code = code_of(line)
    if PASSED_OVER.match(code):
        return
    replaced = lambda found, group, text: line[:found.start(group)] + text + line[found.end(group):]
    for found in OPERATOR.finditer(code):
        kind = {"<": "relation", ">": "relation", "=": "relation", "!": "relation", "&": "logic", "|": "logic"}.get(found[1][0], "arithmetic")
        yield replaced(found, 1, OPERATORS[found[1]]), kind
    for found in WORD.finditer(code):
        group = 1 if found[1] else 2
        yield replaced(found, group, WORDS[found[group]]), "constant" if found[group] in ("true", "false") else "function"
    for found in NUMBER.finditer(code):
        yield replaced(found, 1, changed_number(found[1])), "constant"
    for found in NOT.finditer(code):
        yield replaced(found, 0, ""), "logic"
    if STATEMENT.match(code) and code.count("(") == code.count(")"):
        yield line[:len(line) - len(line.lstrip())] + ";", "dropped statement"


def sites(file, text):
    """All mutations of a file, in the order of its lines."""
    found, in_comment = [], False
    lines = text.splitlines()
    for k, line in enumerate(lines):
        if in_comment or line.lstrip().startswith("/*"):
            in_comment = "*/" not in line
            continue
        begins = k == 0 or re.search(r"[;{}):]\s*$", code_of(lines[k - 1])) or not lines[k - 1].strip()
        for becomes, kind in sites_of_line(line):
            if kind != "dropped statement" or begins:
                found.append(Site(file, k + 1, line.strip(), becomes.strip() if kind != "dropped statement" else "", kind))
    return found
