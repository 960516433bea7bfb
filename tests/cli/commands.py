#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Calls vstudio as a person would, rightly and wrongly. usage: commands.py VSTUDIO [TOPIC[.TEST] ...]"""
import unittest

from commands_by_topic.device_errors import DeviceErrors  # noqa: F401
from commands_by_topic.pictures import Pictures  # noqa: F401
from commands_by_topic.sessions import Sessions  # noqa: F401
from commands_by_topic.sweeps import Sweeps  # noqa: F401
from commands_by_topic.use import Use  # noqa: F401
from commands_by_topic.volumes import Volumes  # noqa: F401

if __name__ == "__main__":
    unittest.main(verbosity=2)
