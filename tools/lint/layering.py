#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the arrows of ARCHITECTURE.md: geometry <- model <- core <- node <- main.

Debian puts every library under one include root, so the compiler cannot tell a core that includes Fast DDS from one that does
not. This reads the #include lines instead. Usage: layering.py [ROOT]; prints one line per wrong arrow, exit status 1 if any.
"""
import re
import sys
from pathlib import Path

# (what the rule is for, pattern of the files it covers, pattern of what these files may include besides the standard library)
ALLOWED = [
    ("interfaces/geometry", r"interfaces/geometry/", r"Eigen/|interfaces/geometry/"),
    ("interfaces/model", r"interfaces/model/", r"Eigen/|interfaces/(geometry|model)/"),
    ("interfaces/topics", r"interfaces/topics/", r"interfaces/(geometry|model|topics)/"),
    ("a core", r"components/gridBuilder/core/", r"Eigen/|octomap/|interfaces/(geometry|model)/|components/gridBuilder/core/"),
    ("a core", r"components/topoGraph/core/", r"Eigen/|ceres/|interfaces/(geometry|model)/|components/topoGraph/core/"),
    ("a core", r"components/(?P<c>\w+)/core/", r"Eigen/|interfaces/(geometry|model)/|components/{c}/core/"),
    ("the simulator's core", r"tools/simulator/core/", r"Eigen/|embree3/|interfaces/(geometry|model)/|tools/simulator/core/"),
]
# (what, files, what they must not include)
FORBIDDEN = [
    ("a component", r"components/(?P<c>\w+)/", r"components/(?!{c}/)|tools/"),
    ("anything but the command", r"tools/(?!enfilade/)", r"tools/enfilade/"),
    ("what the experiments stand on", r"tools/(?!enfilade/|evaluate/)", r"tools/evaluate/"),
    ("an interface", r"interfaces/", r"components/|tools/"),
    ("anything but interfaces/dds, interfaces/convert and their tests", r"(?!interfaces/(dds|convert)/|tests/)", r"fastdds/|fastrtps/|fastcdr/"),
    ("a core", r"(components/\w+|tools/simulator)/core/",
     r"(thread|mutex|chrono|iostream|fstream|ctime|atomic|shared_mutex|semaphore|stop_token|filesystem|pthread\.h|unistd\.h|time\.h|condition_variable|future|random_device)$"),
]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_0-9]+(\.h)?$")


def includes(file):
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1)


def wrong_arrows(root):
    files = sorted(f for top in ("interfaces", "components", "tools", "tests")
                   for f in (root / top).rglob("*.[ch]pp"))
    for file in files:
        path = file.relative_to(root).as_posix()
        allowed = next(((what, m, a) for what, pattern, a in ALLOWED if (m := re.match(pattern, path))), None)
        for number, target in includes(file):
            if allowed:
                what, match, pattern = allowed
                pattern = pattern.format(**match.groupdict()) if match.groupdict() else pattern
                if not STANDARD.match(target) and not re.match(pattern, target):
                    yield f"{path}:{number}: {what} must not include {target}"
            for what, pattern, banned in FORBIDDEN:
                match = re.match(pattern, path)
                if not match:
                    continue
                banned = banned.format(**match.groupdict()) if match.groupdict() else banned
                if re.match(banned, target):
                    yield f"{path}:{number}: {what} must not include {target}"


if __name__ == "__main__":
    top = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    if not top.is_dir():
        sys.exit(f"layering.py: {top} is no folder; give the root of the sources")
    found = sorted(set(wrong_arrows(top)))
    print("\n".join(found))
    sys.exit(1 if found else 0)
