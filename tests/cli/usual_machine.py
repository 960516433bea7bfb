# SPDX-License-Identifier: Apache-2.0
"""How slow this machine is beside those of which limits of processor time are said, for tests with such limits."""
import os
import resource
import subprocess

# Seconds of processor time that a phantom of 128^3 takes on a usual machine.
USUAL = 0.9


def slowness(program, folder):
    """How many times as long as usual this machine takes for what is the same each time; at least 1."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "phantom", "vessels", "--size", "128x128x128", "-o", os.path.join(folder, "phantom.nrrd")],
                   capture_output=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return max(1.0, (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / USUAL)
