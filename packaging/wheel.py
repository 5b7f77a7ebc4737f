# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of the Python module in a build folder: wheel.py BUILD OUT. Prints its path.

The format is that of the binary distribution format 1.0 (PEP 427). The module is linked with the libraries of the
system that it was built on, so the wheel is one for that system: it is tagged linux_x86_64 (or as the machine is), not
manylinux.
"""
import base64
import hashlib
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).parent.parent
METADATA = """Metadata-Version: 2.1
Name: roomcast
Version: {version}
Summary: Live rooms from several RGB-D sensors
License: Apache-2.0
Requires-Python: =={python}.*
Requires-Dist: numpy
Description-Content-Type: text/markdown

{guide}"""
WHEEL = """Wheel-Version: 1.0
Generator: roomcast
Root-Is-Purelib: false
Tag: {tag}
"""
WRITTEN_AT = (2020, 1, 1, 0, 0, 0)  # the same files give the same wheel


def stripped(library):
    with tempfile.NamedTemporaryFile() as out:
        subprocess.run(["strip", "--strip-unneeded", "-o", out.name, str(library)], check=True)
        return Path(out.name).read_bytes()


def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def write(path, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, WRITTEN_AT)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data)


def main(build, out):
    version = (Path(build) / "python/version").read_text().strip()
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    package = Path(build) / "python/roomcast"
    module = package / ("_core" + sysconfig.get_config_var("EXT_SUFFIX"))
    files = {f"roomcast/{module.name}": stripped(module)}
    for name in ("__init__.py", "__init__.pyi", "py.typed"):
        files[f"roomcast/{name}"] = (package / name).read_bytes()
    info = f"roomcast-{version}.dist-info"
    guide = (ROOT / "docs/guides/python.md").read_text()
    python_version = f"{sys.version_info.major}.{sys.version_info.minor}"
    files[f"{info}/METADATA"] = METADATA.format(version=version, python=python_version, guide=guide).encode()
    files[f"{info}/WHEEL"] = WHEEL.format(tag=tag).encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    record = "".join(record_line(name, data) for name, data in files.items()) + f"{info}/RECORD,,\n"
    files[f"{info}/RECORD"] = record.encode()
    Path(out).mkdir(parents=True, exist_ok=True)
    path = Path(out) / f"roomcast-{version}-{tag}.whl"
    write(path, files)
    print(path)


if __name__ == "__main__":
    main(*sys.argv[1:3])
