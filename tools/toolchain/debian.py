"""Debian packages unpacked into a private folder: no root, no change of the system.

apt-get works on folders of its own with an empty status file, so it brings a package with all that it depends on, from
the same mirror and checked with the same keys as the machine's own packages. The packages are those of Debian testing,
since no stable release has Godot 4, or of the machine's own release for what must fit its C library.
"""

import os
import re
import shutil
import subprocess
from pathlib import Path

from .place import Missing, TOOLCHAIN, say

SUITE = "testing"
OWN = "own"  # The suite that this machine runs.
KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
PACKAGES_URI = re.compile(r"^'(\S+/)dists/([^/\s]+)/([^/\s]+)/binary-[^/\s]+/Packages", re.MULTILINE)


def release_name(os_release):
    """The code name of the Debian release that the text of /etc/os-release describes; None for anything else."""
    fields = dict(re.findall(r'^(\w+)="?([^"\n]*)"?$', os_release, re.MULTILINE))
    return fields.get("VERSION_CODENAME") if fields.get("ID") == "debian" else None


def choose_mirrors(uris, codename):
    """The addresses of the Debian mirrors that this machine has configured, likeliest first.

    `uris` is what `apt-get update --print-uris` prints, which needs neither root nor lists. Sources of others that
    serve the same release have a component of another name, or no -updates beside them.
    """
    rows = PACKAGES_URI.findall(uris)
    with_updates = {mirror for mirror, release, _ in rows if release == f"{codename}-updates"}
    suites = (codename, "stable", "oldstable", "testing", "unstable", "sid")
    ranked = {}
    for mirror, release, component in rows:
        if release in suites and component == "main":
            rank = (mirror not in with_updates, suites.index(release))
            ranked[mirror] = min(ranked.get(mirror, rank), rank)
    return sorted(ranked, key=lambda mirror: ranked[mirror])


def signing_key(sources, mirror):
    """The keyring for `mirror`: what the apt sources among the texts `sources` that name it say, else Debian's own file.

    None leaves it to the keys that apt trusts for everything.
    """
    named = [key for text in sources if mirror.rstrip("/") in text
             for key in re.findall(r"signed-by\s*[:=]\s*(/[^\s\],]+)", text, re.IGNORECASE)]
    candidates = sorted(named, key=lambda path: "debian-archive" not in path) + [KEYRING]
    return next((path for path in candidates if os.path.exists(path)), None)


def configured_sources():
    """The texts of the machine's apt sources."""
    apt = Path("/etc/apt")
    paths = [apt / "sources.list", *sorted(apt.glob("sources.list.d/*.list")), *sorted(apt.glob("sources.list.d/*.sources"))]
    return [path.read_text(errors="replace") for path in paths if os.access(path, os.R_OK)]


class Apt:
    """apt-get with private folders below `home`, for packages of a Debian `suite` and, by default, of this machine's
    architecture."""

    def __init__(self, home, suite=SUITE, architecture=None):
        self.home = Path(home)
        self.suite = suite
        self.architecture = architecture
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
            # Mirrors may be frozen and clocks wrong; the signature is checked all the same.
            "Acquire::Check-Valid-Until": "false",
            "Acquire::Languages": "none",
            "Acquire::Retries": "3",
            "Debug::NoLocking": "true",
        }
        if self.architecture:
            options.update({"APT::Architecture": self.architecture, "APT::Architectures": self.architecture})
        return ["apt-get", "-q", *(f"-o{name}={value}" for name, value in options.items()), *words]

    def call(self, *words):
        return subprocess.run(self.command(*words), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              stdin=subprocess.DEVNULL, env={**os.environ, "LC_ALL": "C"})

    def offer(self, mirrors, packages):
        """Reads the lists of the first mirror that has `packages`. Returns (number and bytes to fetch, apt's complaint)."""
        answer = "apt has no Debian mirror configured"
        for mirror in mirrors:
            key = signing_key(configured_sources(), mirror)
            options = f"[signed-by={key}] " if key else ""
            (self.home / "private.list").write_text(f"deb {options}{mirror} {self.suite} main\n")
            for words in (("update",), ("install", "--print-uris", "--assume-yes", *packages)):
                result = self.call(*words)
                answer = result.stdout.strip()
                if result.returncode != 0:
                    break
            else:
                sizes = re.findall(r"^'\S+' \S+\.deb (\d+)", answer, re.MULTILINE)
                return (len(sizes), sum(map(int, sizes))), None
        return None, answer

    def download(self, packages):
        """The paths of the packages' files, with all that they depend on; and apt's complaint if it failed."""
        result = self.call("install", "--download-only", "--assume-yes", *packages)
        return sorted((self.home / "cache/archives").glob("*.deb")), result.stdout if result.returncode else None


def last_lines(text, count=6):
    return "\n".join("  " + line for line in text.strip().splitlines()[-count:])


def unpack(what, packages, folder, remedy, suite=SUITE, architecture=None):
    """Unpacks Debian's `packages` and their dependencies into `folder`. `what` and `remedy` are for the messages."""
    codename = release_name(Path("/etc/os-release").read_text()) if os.path.exists("/etc/os-release") else None
    if not codename or not shutil.which("apt-get") or not shutil.which("dpkg"):
        raise Missing(f"{what} is missing, and only on Debian can it be fetched here.\n{remedy}")
    suite = codename if suite == OWN else suite
    say(f"Looking for {what} in Debian {suite}")
    home = Path(folder) / "apt"
    apt = Apt(home, suite, architecture)
    uris = subprocess.run(["apt-get", "update", "--print-uris", "-oDebug::NoLocking=true"], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout
    offer, problem = apt.offer(choose_mirrors(uris, codename), packages)
    if offer:
        say(f"Fetching {what}: {offer[0]} packages, {offer[1] / 1e6:.1f} MB, unpacked privately in {TOOLCHAIN.name}/")
        archives, problem = apt.download(packages)
    if problem:
        raise Missing(f"{what} is missing, and apt could not fetch it from Debian {suite}:\n"
                      f"{last_lines(problem)}\n{remedy}")
    for package in archives:
        if subprocess.run(["dpkg", "-x", str(package), str(folder)]).returncode != 0:
            raise Missing(f"{what}: {package.name} could not be unpacked (is the disk full?).\n{remedy}")
    shutil.rmtree(home)
