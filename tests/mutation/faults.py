"""Derives faults from the library's own text: where a bound, a width, an operator, a constant, a step or a rule can be wrong."""
import hashlib
import re
from pathlib import Path

_LITERAL = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
# What only compiles, prints no value or is decided before the program runs: a fault there is none in behaviour.
_IDLE = re.compile(r"^\s*(#|using |template ?<|static_assert|namespace |public:|private:|requires|concept |friend )")

# (kind, what to look for, what to put in its place). Patterns see code without comments and strings.
_RULES = [
    ("compare", r" < ", " <= "), ("compare", r" <= ", " < "), ("compare", r" > ", " >= "), ("compare", r" >= ", " > "),
    ("compare", r" == ", " != "), ("compare", r" != ", " == "),
    ("logic", r" && ", " || "), ("logic", r" \|\| ", " && "), ("logic", r"(?<=[(\s])!(?=[\w(])", ""),
    ("logic", r"\bif \((\w[\w.]*(?:\(\))?)\)", lambda m: f"if (!{m.group(1)})"),
    ("arithmetic", r" \+ ", " - "), ("arithmetic", r" - ", " + "), ("arithmetic", r" \* ", " + "), ("arithmetic", r" % ", " / "), ("arithmetic", r" / ", " * "),
    ("arithmetic", r"\+\+(?=\w)", "--"), ("arithmetic", r" \+= ", " -= "), ("arithmetic", r" -= ", " += "),
    ("bits", r" << (?=\d|\()", " >> "), ("bits", r" >> ", " << "), ("bits", r" & (?=\w)", " | "), ("bits", r" \| ", " & "), ("bits", r" \|= ", " &= "), ("bits", r" &= ", " |= "),
    ("crc", r" \^= ", " |= "), ("crc", r" \^ ", " | "), ("crc", r" \^= ", " += "), ("crc", r"\b_mm_xor_si128\b", "_mm_or_si128"),
    ("answer", r"\breturn true;", "return false;"), ("answer", r"\breturn false;", "return true;"),
    ("answer", r"= true;", "= false;"), ("answer", r"= false;", "= true;"),
    ("code", r"\berrc::truncated\b", "errc::noise"), ("code", r"\berrc::bad_length\b", "errc::bad_checksum"), ("code", r"\berrc::noise\b", "errc::bad_length"),
    ("code", r"\berrc::bad_checksum\b", "errc::noise"), ("code", r"\berrc::bad_character\b", "errc::bad_length"), ("code", r"\berrc::incomplete\b", "errc::timed_out"),
    ("code", r"\berrc::timed_out\b", "errc::incomplete"), ("code", r"\berrc::bad_number\b", "errc::bad_length"),
    ("code", r"\berrc::unknown_message\b(?=[,;)])", "errc::bad_length"), ("code", r"\berrc::out_of_range\b(?=[,;)])", "errc::buffer_too_small"),
    ("width", r"\bwire::u8\b", "wire::u16"), ("width", r"\bwire::u16\b", "wire::i16"), ("width", r"\bwire::i16\b", "wire::u16"), ("width", r"\bwire::i32\b", "wire::i16"),
    ("width", r"\bwire::dec<(\d+)>", lambda m: f"wire::dec<{int(m.group(1)) + 1}>"), ("width", r"\bwire::chars<(\d+)>", lambda m: f"wire::chars<{int(m.group(1)) - 1}>"),
    ("width", r"\bwire::signed_dec<(\d+)>", lambda m: f"wire::dec<{m.group(1)}>"), ("width", r"\bjustify::right\b", "justify::left"),
    ("bound", r"\bbetween\((\w+), (\w+)\)", lambda m: f"between({m.group(1)}, {m.group(2)} + 1)"), ("bound", r"\bbetween\((\w+), (\w+)\)", lambda m: f"between({m.group(1)} + 1, {m.group(2)})"),
    ("bound", r"\bstd::min\b", "std::max"), ("bound", r"\bstd::max\b", "std::min"),
    ("constant", r"(?<![\w.<'])(0[xX][0-9A-Fa-f]+|\d+)(?![\w.'>])", lambda m: m.group(1) + " + 1"),
    ("constant", r"(?<![\w.<'])(0[xX]0*[1-9A-Fa-f][0-9A-Fa-f]*|[1-9]\d*)(?![\w.'>])", lambda m: m.group(1) + " - 1"),
    # A statement that is left out: a step, an assignment, a call; also as all that a condition stands before.
    ("step", r"(?m)^(\s*)(?:\+\+|--)?\w+_(?:\.\w+\([^;{}]*\)|\[[^\]]*\])?(?: [-+|&^]?= [^;]+)?;$", lambda m: m.group(1) + ";"),
    ("step", r"(?m)^(\s*)\*?\w+(?:(?:\.|->)\w+|\[[^\]]*\])*(?: [-+|&^]?= [^;]+|\([^;{}]*\));$", lambda m: m.group(1) + ";"),
    ("step", r"(?m)^(\s*(?:\} )?(?:else )?if \((?:[^;{}()]|\((?:[^;{}()]|\([^;{}()]*\))*\))*\) )(?!return\b|throw\b|break\b|continue\b)[^;{}()]*(?: [-+|&^]?= [^;{}]+|\([^;{}]*\));$", lambda m: m.group(1) + ";"),
    ("slot", r"\border_use::current\b", "order_use::next"), ("slot", r"\border_use::previous\b", "order_use::unused"),
    ("slot", r"\border_use::next\b", "order_use::current"), ("slot", r"\border_use::unused\b", "order_use::previous"),
    ("slot", r"\btransit_phase::transit_done\b", "transit_phase::transiting"), ("slot", r"\btransit_phase::go_transit\b", "transit_phase::none"),
    ("slot", r"\btransit_phase::none\b", "transit_phase::go_transit"), ("slot", r"\btransit_phase::transiting\b", "transit_phase::transit_done"),
]


class Fault:
    """One replacement in one file."""

    def __init__(self, path, text, start, end, new, kind):
        self.path, self.kind, self.start, self.end, self.new = path, kind, start, end, new
        self.old = text[start:end]
        self.line = text.count("\n", 0, start) + 1
        self.source = text[text.rfind("\n", 0, start) + 1:text.find("\n", end) if text.find("\n", end) >= 0 else len(text)].strip()
        # The same whatever moves above it in the file, unless the line itself changes.
        same = text.count(self.source, 0, start)
        self.ident = hashlib.sha1(f"{path}|{kind}|{self.source}|{same}|{start - text.rfind(chr(10), 0, start)}|{self.old}|{new}".encode()).hexdigest()[:8]

    def applied_to(self, text):
        return text[:self.start] + self.new + text[self.end:]

    @property
    def what(self):
        """What it changes, wherever the line stands."""
        return f"{self.path}: `{self.old.strip()}` becomes `{self.new.strip() or 'nothing'}` in `{self.source}`"

    @property
    def title(self):
        return f"{self.path}:{self.line} {self.kind}: `{' '.join(self.old.split())}` becomes `{self.new.strip() or 'nothing'}`"


def blanked(text):
    """The text with comments, strings, idle lines and other machines' code replaced by as many blanks, so that places stay the same."""
    text = _LITERAL.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)
    lines = []
    for line, foreign in zip(text.split("\n"), _foreign(text), strict=True):
        lines.append(" " * len(line) if foreign or _IDLE.match(line) else line)
    return "\n".join(lines)


def code_of(text):
    """The text without comments and what its strings say."""
    return " ".join(_LITERAL.sub(lambda m: " " if m.group(0).startswith("/") else '""' if m.group(0).startswith('"') else m.group(0), text).split())


def _foreign(text):
    """For each line, whether it stands behind `#else` of vector code: this machine does not compile it."""
    open_blocks = []  # of each #if: [does it choose among vector extensions, is this another machine's branch]
    for line in text.split("\n"):
        directive = line.split()[0] if line.startswith("#") else ""
        if directive in ("#if", "#ifdef", "#ifndef"):
            open_blocks.append(["__SSE2__" in line, False])
        elif directive in ("#else", "#elif"):
            open_blocks[-1][1] = open_blocks[-1][0]
        elif directive == "#endif":
            open_blocks.pop()
        yield any(foreign for _, foreign in open_blocks)


def faults_in(path, text):
    """Every fault that the rules find in one file."""
    code = blanked(text)
    found, seen = [], set()
    for kind, pattern, new in _RULES:
        for m in re.finditer(pattern, code):
            replacement = new(m) if callable(new) else new
            # A whole line that goes may have held a string, whose place is blank in `code`.
            if replacement == m.group(0) or (m.start(), replacement) in seen:
                continue
            seen.add((m.start(), replacement))
            found.append(Fault(path, text, m.start(), m.end(), replacement, kind))
    return found


def files(root):
    return sorted((root / "include").rglob("*.hpp")) + sorted((root / "src").glob("*.cpp"))


def all_faults(root):
    """Every fault in the library: include/ and the sources directly in src/. In front stand all those of the checksums and of the order
    slots, which are few; the rest is ordered so that any front part of it is a fair sample."""
    found = []
    for path in files(root):
        name = path.relative_to(root).as_posix()
        found += faults_in(name, path.read_text())
    return [f for f in found if f.kind in ("crc", "slot")] + deal([f for f in found if f.kind not in ("crc", "slot")])


def deal(faults):
    """Deals the faults out file by file and, in a file, kind by kind, the rare kinds first."""
    often = {}
    for f in faults:
        often[f.kind] = often.get(f.kind, 0) + 1
    by_file = {}
    for f in sorted(faults, key=lambda f: f.ident):
        by_file.setdefault(f.path, {}).setdefault(f.kind, []).append(f)
    hands = []
    for path in sorted(by_file):
        kinds = [by_file[path][k] for k in sorted(by_file[path], key=lambda k: (often[k], k))]
        hand = []
        while any(kinds):
            for k in kinds:
                if k:
                    hand.append(k.pop(0))
        hands.append(hand)
    order = []
    while any(hands):
        for hand in hands:
            # A long file has more to go wrong in.
            for _ in range(1 + len(hand) // 60):
                if hand:
                    order.append(hand.pop(0))
    return order
