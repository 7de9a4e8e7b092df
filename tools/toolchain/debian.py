"""Debian packages unpacked into a private folder: no root, no change of the system.

apt-get works on folders of its own with an empty status file, so it brings a package with all that it depends on, from
the same mirror and checked with the same keys as the machine's own packages. The packages are those of Debian testing,
since no stable release has Godot 4.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

from .place import Missing, TOOLCHAIN, say

SUITE = "testing"
KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
TARGET_FIELDS = "$(REPO_URI)|$(RELEASE)|$(COMPONENT)|$(ORIGIN)|$(SOURCESENTRY)"


def release_name(os_release):
    """The code name of the Debian release that the text of /etc/os-release describes; None for anything else."""
    fields = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', os_release, re.MULTILINE))
    return fields.get("VERSION_CODENAME") if fields.get("ID") == "debian" else None


def choose_mirrors(targets, codename):
    """The Debian mirrors among apt's index targets, likeliest first, as (uri, file that configures it).

    `targets` is what `apt-get indextargets --format TARGET_FIELDS` prints. Sources of others that serve the same
    release have a component of another name, or no -updates beside them, or (once lists are there) another origin.
    """
    rows = [line.split("|") for line in targets.splitlines() if line.count("|") == 4]
    with_updates = {uri for uri, release, *_ in rows if release == f"{codename}-updates"}
    suites = (codename, "stable", "oldstable", "testing", "unstable", "sid")
    ranked = {}
    for uri, release, component, origin, entry in rows:
        foreign = origin not in ("Debian", "", "$(ORIGIN)")
        if release not in suites or component != "main" or uri.startswith("cdrom:") or foreign:
            continue
        rank = (origin != "Debian", uri not in with_updates, suites.index(release))
        ranked[uri] = min(ranked.get(uri, (rank, entry)), (rank, entry))
    return [(uri, entry.rsplit(":", 1)[0]) for uri, (_, entry) in sorted(ranked.items(), key=lambda item: item[1])]


def signing_key(configuration):
    """The keyring that the text of an apt source names, else Debian's own file; None leaves it to apt's trusted keys."""
    named = re.findall(r"signed-by\s*[:=]\s*(/[^\s\],]+)", configuration, re.IGNORECASE)
    candidates = sorted(named, key=lambda path: "debian-archive" not in path) + [KEYRING]
    return next((path for path in candidates if os.path.exists(path)), None)


class Apt:
    """apt-get with private folders below `home`."""

    def __init__(self, home):
        self.home = Path(home)
        for folder in ("lists/partial", "cache/archives/partial"):
            (self.home / folder).mkdir(parents=True, exist_ok=True)
        for empty in ("status", "none"):
            (self.home / empty).write_text("")

    def command(self, *words):
        options = {
            "Dir::State": self.home,
            "Dir::State::lists": self.home / "lists",
            "Dir::State::status": self.home / "status",
            "Dir::Cache": self.home / "cache",
            "Dir::Etc::sourcelist": self.home / "private.list",
            "Dir::Etc::sourceparts": "/dev/null",
            "Dir::Etc::preferences": self.home / "none",
            "Dir::Etc::preferencesparts": "/dev/null",
            "APT::Install-Recommends": "false",
            "APT::Sandbox::User": "root",
            "APT::Update::Error-Mode": "any",
            "Acquire::Languages": "none",
            "Acquire::Retries": "3",
            "Debug::NoLocking": "true",
        }
        return ["apt-get", "-q", *(f"-o{name}={value}" for name, value in options.items()), *words]

    def call(self, *words):
        return subprocess.run(self.command(*words), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              stdin=subprocess.DEVNULL, env={**os.environ, "LC_ALL": "C"})

    def update_from(self, mirrors):
        """Reads the package lists of the first mirror that has them; returns apt's words where none does."""
        answer = "apt has no Debian mirror configured"
        for uri, configured_in in mirrors:
            text = Path(configured_in).read_text(errors="replace") if os.path.exists(configured_in) else ""
            key = signing_key(text)
            options = f"[signed-by={key}] " if key else ""
            (self.home / "private.list").write_text(f"deb {options}{uri} {SUITE} main\n")
            result = self.call("update")
            if result.returncode == 0:
                return None
            answer = result.stdout.strip()
        return answer

    def download(self, packages):
        """The paths of the packages' files, with all that they depend on."""
        size = re.search(r"Need to get ([\d.,]+ \w+)", self.call("install", "--assume-no", *packages).stdout)
        say(f"  {' '.join(packages[:3])}{' …' if len(packages) > 3 else ''}: {size.group(1) if size else 'packages'}")
        result = self.call("install", "--download-only", "--assume-yes", *packages)
        if result.returncode != 0:
            raise Missing(f"apt could not fetch {' '.join(packages)}:\n{last_lines(result.stdout)}")
        return sorted((self.home / "cache/archives").glob("*.deb"))


def last_lines(text, count=6):
    return "\n".join("  " + line for line in text.strip().splitlines()[-count:])


def unpack(what, packages, folder, remedy):
    """Unpacks Debian's `packages` and their dependencies into `folder`. `what` and `remedy` are for the messages."""
    codename = release_name(Path("/etc/os-release").read_text()) if os.path.exists("/etc/os-release") else None
    if not codename or not shutil.which("apt-get") or not shutil.which("dpkg"):
        raise Missing(f"{what} is missing, and only on Debian can it be fetched here.\n{remedy}")
    say(f"Fetching {what} (Debian {SUITE}, unpacked privately in {TOOLCHAIN.name}/)")
    home = Path(folder) / "apt"
    apt = Apt(home)
    targets = subprocess.run(["apt-get", "indextargets", "--format", TARGET_FIELDS, "Created-By: Packages"],
                             stdout=subprocess.PIPE, text=True).stdout
    problem = apt.update_from(choose_mirrors(targets, codename))
    if problem:
        raise Missing(f"{what} is missing, and apt could not read the lists of Debian {SUITE}:\n"
                      f"{last_lines(problem)}\n{remedy}")
    for package in apt.download(packages):
        if subprocess.run(["dpkg", "-x", str(package), str(folder)]).returncode != 0:
            raise Missing(f"{what}: {package.name} could not be unpacked (is the disk full?).\n{remedy}")
    shutil.rmtree(home)
