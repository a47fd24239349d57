#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Resident memory of gridBuilder and roomDetector as processes over DDS, in the hall of hall.yaml seen up to 30 m.

    tools/evaluate/memory/measure.py [--build build/release] [--seconds 40] [--domain N] [--transport udp|shared_memory]

The robot stands and sweeps the whole hall again and again, as in `enfilade evaluate latency`, which starts the processes.
"""
import argparse
import pathlib
import subprocess
import time

PARTS = ("gridBuilder", "roomDetector")
GOAL_MB = 120


def status(pid):
    """The fields of /proc/PID/status; empty where there is no such process any more."""
    try:
        lines = pathlib.Path(f"/proc/{pid}/status").read_text(encoding="ascii").splitlines()
    except OSError:
        return {}
    return dict(line.split(":\t", 1) for line in lines if ":\t" in line)


def members(parent):
    """Process ids of the parts that `parent` has started, by name."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        fields = status(folder.name)
        if fields.get("PPid") == str(parent) and fields.get("Name") in PARTS:
            found[fields["Name"]] = folder.name
    return found


def megabytes(fields, key):
    return int(fields.get(key, "0 kB").split()[0]) / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/release")
    parser.add_argument("--seconds", type=float, default=40)
    parser.add_argument("--domain", default="0")
    parser.add_argument("--transport", default="udp", choices=["udp", "shared_memory"])
    arguments = parser.parse_args()
    if not pathlib.Path(arguments.build, "bin/enfilade").exists():
        parser.error(f"{arguments.build}/bin/enfilade is not there; build it, or give the folder of another build with --build")
    command = [f"{arguments.build}/bin/enfilade", "evaluate", "latency",
               "--world", str(pathlib.Path(__file__).with_name("hall.yaml")),
               "--seconds", str(arguments.seconds), "--transport", arguments.transport,
               "--set", "gridBuilder.grid.max_range_m=30", "--set", "gridBuilder.grid.max_height_m=6.5"]
    if arguments.domain != "0":
        command += ["--domain", arguments.domain]
    peak, last = {}, {}
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as run:
        while run.poll() is None:
            for name, pid in members(run.pid).items():
                fields = status(pid)
                if not megabytes(fields, "VmRSS"):
                    continue
                last[name] = fields
                peak[name] = max(peak.get(name, 0), megabytes(fields, "VmRSS"))
            time.sleep(0.5)
        if run.returncode != 0 or len(peak) != len(PARTS):
            raise SystemExit(f"the run failed with status {run.returncode}")
    print(f"{'MB':<14}{'resident':>10}{'of its own':>10}{'most':>8}")
    for name in PARTS:
        own = megabytes(last[name], "RssAnon")
        print(f"{name:<14}{megabytes(last[name], 'VmRSS'):>10.1f}{own:>10.1f}{peak[name]:>8.1f}")
    print(f"{'both':<14}{sum(megabytes(f, 'VmRSS') for f in last.values()):>10.1f}{'':>10}{sum(peak.values()):>8.1f}"
          f"   (goal: {GOAL_MB})")


if __name__ == "__main__":
    main()
