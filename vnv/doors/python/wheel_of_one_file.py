# SPDX-License-Identifier: MIT
"""Builds the wheel of touchstone.py for pip: a build backend (PEP 517) of the standard library alone, which writes nothing beside
its sources, so that `pip install` needs neither a network nor a folder that can be written."""

import base64
import hashlib
import pathlib
import zipfile

NAME = "touchstone_judge-0.2.0"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    files = {
        "touchstone.py": (pathlib.Path(__file__).parent / "touchstone.py").read_text(encoding="utf-8"),
        f"{NAME}.dist-info/METADATA": "Metadata-Version: 2.1\nName: touchstone-judge\nVersion: 0.2.0\nLicense: MIT\n",
        f"{NAME}.dist-info/WHEEL": "Wheel-Version: 1.0\nGenerator: wheel_of_one_file\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    record = f"{NAME}.dist-info/RECORD"
    files[record] = "".join(f"{name},sha256={_digest(text)},{len(text.encode())}\n" for name, text in files.items()) + f"{record},,\n"
    wheel = f"{NAME}-py3-none-any.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return wheel


def _digest(text):
    return base64.urlsafe_b64encode(hashlib.sha256(text.encode()).digest()).rstrip(b"=").decode()
