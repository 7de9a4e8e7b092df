#!/usr/bin/env python3
"""Writes build/undergrowth-demo-VERSION-SYSTEM.zip: the demo as a game, by the engine's release templates. It
contains the add-on from the zip of `./run package`, and there is a game for each system with a release library in that zip.
"""

import argparse
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

from building import project
from shipping import archive

ROOT = archive.ROOT
OUT = ROOT / "build/demo_zip"
TIMEOUT = 900  # s, of an import or an export.
# {system: (its platform in Godot, the game's file, the release library that it needs)}
SYSTEMS = {
    "linux": ("Linux", "undergrowth_demo.x86_64", "libundergrowth.linux.template_release.x86_64.so"),
    "windows": ("Windows Desktop", "undergrowth_demo.exe", "libundergrowth.windows.template_release.x86_64.dll"),
}
PRESET = """[preset.{number}]

name="{system}"
platform="{platform}"
runnable=true
export_filter="all_resources"
include_filter=""
exclude_filter=""
export_path=""

[preset.{number}.options]

custom_template/release="{template}"
binary_format/embed_pck=false
binary_format/architecture="x86_64"
"""


class NotExported(Exception):
    """The text says why, and what to do."""


def systems_of(names):
    """The systems with a release library among the `names` of the zip with the add-on."""
    held = {Path(name).name for name in names}
    return [system for system, (_, _, library) in SYSTEMS.items() if library in held]


def presets(systems, template=""):
    """The text of export_presets.cfg. `template`: a release template in place of an installed one."""
    return "\n".join(PRESET.format(number=number, system=system, platform=SYSTEMS[system][0], template=template)
                     for number, system in enumerate(systems))


def make_project(addon_zip, template):
    """Creates the demo project with the add-on of the zip in OUT. Returns its systems."""
    shutil.rmtree(OUT, ignore_errors=True)
    folder = OUT / "project"
    shutil.copytree(ROOT / "demo_project", folder, ignore=shutil.ignore_patterns("addons", ".godot"))
    with zipfile.ZipFile(addon_zip) as packed:
        packed.extractall(folder)
        systems = systems_of(packed.namelist())
    if not systems:
        raise NotExported(f"{addon_zip.name} has no release library of {' or '.join(SYSTEMS)}: say `./run build target=both` "
                          "before `./run package here=yes`.")
    (folder / "export_presets.cfg").write_text(presets(systems, template), encoding="utf-8")
    project.list_extensions(folder)
    return systems


def call(godot, *words):
    """Starts the engine on the project. Returns its exit status and its output."""
    done = subprocess.run([godot, "--headless", "--path", OUT / "project", *words], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=TIMEOUT)
    return done.returncode, done.stdout


def export(godot, system):
    """Exports the game. Returns the path of its zip."""
    game = OUT / system / SYSTEMS[system][1]
    game.parent.mkdir(parents=True)
    status, output = call(godot, "--export-release", system, game)
    if status != 0 or not game.exists():
        raise NotExported(f"Godot exported no game for {system} (exit status {status}). Install its export templates, or "
                          f"say template=PATH.\n{output[-2000:]}")
    shutil.copy(ROOT / "LICENSE", game.parent)
    shutil.copy(ROOT / archive.ADDON / "THIRD_PARTY.md", game.parent)
    target = ROOT / f"build/undergrowth-demo-{archive.version()}-{system}.zip"
    target.unlink(missing_ok=True)
    archive.write(target, {f"undergrowth_demo/{path.name}": path for path in sorted(game.parent.iterdir())})
    return target


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--godot", required=True)
    parser.add_argument("--here", action="store_true", help="the add-on that `./run package here=yes` wrote")
    parser.add_argument("--template", default="", help="a release template in place of the engine's")
    options = parser.parse_args()
    try:
        systems = make_project(archive.place(is_for_all=not options.here), options.template)
        status, output = call(options.godot, "--import")
        if status != 0:
            raise NotExported(f"The demo project could not be imported (exit status {status}).\n{output[-2000:]}")
        for system in systems:
            made = export(options.godot, system)
            print(f"{made.relative_to(ROOT)}: {made.stat().st_size / 1e6:.1f} MB")
    except NotExported as problem:
        print(problem)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
