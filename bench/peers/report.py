# SPDX-License-Identifier: Apache-2.0
"""From milliseconds per frame to medians, ratios and a table."""
import math
import statistics

OURS = "vstudio"


def geometric_mean(values):
    return math.exp(statistics.fmean(math.log(value) for value in values))


def summarise(times):
    """`times`: milliseconds by volume, mode and program. A ratio is the faster peer's median over ours: above 1,
    vstudio is the faster one. Means are geometric, over the volumes of a mode."""
    rows = []
    for volume, modes in times.items():
        for mode, programs in modes.items():
            medians = {program: statistics.median(frames) for program, frames in programs.items()}
            peers = {program: value for program, value in medians.items() if program != OURS}
            faster = min(peers, key=peers.get)
            rows.append({"volume": volume, "mode": mode, "medians": medians, "fasterPeer": faster,
                         "ratio": peers[faster] / medians[OURS],
                         "frames": {program: len(frames) for program, frames in programs.items()}})
    modes = {row["mode"]: None for row in rows}
    means = {mode: geometric_mean([row["ratio"] for row in rows if row["mode"] == mode]) for mode in modes}
    return {"rows": rows, "geometricMeans": means}


def markdown(result):
    programs = list(dict.fromkeys(program for row in result["rows"] for program in row["medians"]))
    width, height = result["size"]
    other = "vstudio before" if "before" in programs else "the faster VTK mapper"
    lines = [f"Milliseconds per frame of {width} x {height} pixels, median; ratio: {other} over vstudio.",
             "", "| mode | volume | " + " | ".join(programs) + " | ratio |",
             "|---|---|" + "---:|" * (len(programs) + 1)]
    for mode, mean in result["geometricMeans"].items():
        for row in (row for row in result["rows"] if row["mode"] == mode):
            cells = [f"{row['medians'][program]:.1f}" if program in row["medians"] else "" for program in programs]
            lines.append(f"| {mode} | {row['volume']} | " + " | ".join(cells) + f" | {row['ratio']:.2f} |")
        lines.append(f"| {mode} | **geometric mean** |" + " |" * len(programs) + f" **{mean:.2f}** |")
    lines += ["", *(f"- {program}: {device}" for program, device in result.get("devices", {}).items())]
    return "\n".join(lines)
