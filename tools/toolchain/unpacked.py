"""Starting programs that lie in an unpacked folder of Debian packages, beside an older system.

They need the folder's own C library, and some have the places of other files compiled in.
"""

import os
import shlex
import shutil
import subprocess

from .place import Missing

# One script for each program. It starts through the folder's loader and finds everything from where itself lies.
WRAPPER = """#!/bin/sh
root=$(dirname "$(dirname "$(readlink -f "$0")")")/godot
lib=$root/@LIBRARIES@
@PREPARE@
exec "$root/@LOADER@" --library-path "@PATH@" "$root/usr/bin/@PROGRAM@" @OPTIONS@"$@"
"""
# Says where the folder was when its programs were given their loader.
HOME = "home.txt"
LIBRARY_FOLDERS = ("", "/pulseaudio", "/blas", "/lapack")
DRAWING = """export LIBGL_DRIVERS_PATH="$lib/dri" VK_DRIVER_FILES="$root/usr/share/vulkan/icd.d/lvp_icd.json"
export __EGL_VENDOR_LIBRARY_DIRS="$root/usr/share/glvnd/egl_vendor.d"
export XKB_CONFIG_ROOT="$root/@XKB@" XLOCALEDIR="$root/usr/share/X11/locale"
[ -e /etc/fonts/fonts.conf ] || export FONTCONFIG_FILE="$root/fonts.conf"
# Started as itself the editor can start itself again; after the folder was moved its loader's address is wrong.
[ "$root" != @HOME@ ] || exec "$root/usr/bin/godot" "$@\""""
XVFB = """PATH=$(dirname "$(readlink -f "$0")"):$PATH
export PATH LIBGL_DRIVERS_PATH="$lib/dri\""""
FONTS = """<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir prefix="relative">usr/share/fonts</dir><cachedir prefix="xdg">fontconfig</cachedir></fontconfig>
"""


def loader_of(folder):
    """The dynamic loader in an unpacked folder, relative to it."""
    return sorted(folder.glob("usr/lib*/ld-linux*.so*"))[0].relative_to(folder)


def libraries_of(folder, library="libc.so.6"):
    """The folder of the libraries, relative to the unpacked one: the one that has `library`."""
    return next(path.parent for path in folder.glob(f"usr/lib/*/{library}")).relative_to(folder)


def loader_words(folder, more=()):
    """The words that start a program with the loader and the libraries of an unpacked folder, and `more` folders of them."""
    own = folder / libraries_of(folder)
    search = ":".join([*(f"{own}{below}" for below in LIBRARY_FOLDERS), *map(str, more)])
    return [str(folder / loader_of(folder)), "--library-path", search]


def find_xkbcomp_on_path(server):
    """Lets the private X server find its keymap compiler through PATH.

    Its folder is compiled in as /usr/bin. Emptying that text leaves the bare name, which the shell looks up.
    """
    data = server.read_bytes()
    if data.count(b"\0/usr/bin\0") != 1:
        raise Missing("Debian's Xvfb has changed: the folder of its keymap compiler is not where it was.\n"
                      "Say GODOT=/path/to/godot (4.6 or newer) and install Xvfb yourself.")
    server.write_bytes(data.replace(b"\0/usr/bin\0", b"\0\0usr/bin\0"))


def give_own_loader(folder, home, program, others=()):
    """Makes `program` in `folder`, which will lie at `home`, start by its own name with the folder's loader and libraries.
    Where it names `others`, too, it can be copied to any place.

    Started through the loader the engine takes that for itself: the editor's play button would start the loader.
    """
    libraries = libraries_of(folder)
    patch = [folder / loader_of(folder), "--library-path", folder / libraries, folder / "usr/bin/patchelf"]
    # A library's own search path would hide that of the program.
    for library in (folder / libraries).glob("*.so*"):
        if not library.is_symlink() and subprocess.run([*patch, "--print-rpath", library], stdout=subprocess.PIPE,
                                                       stderr=subprocess.DEVNULL).stdout.strip():
            subprocess.run([*patch, "--remove-rpath", library], check=True)
    up = os.path.relpath(libraries, os.path.dirname(program))
    places = [home / libraries, *(place / libraries for place in others)] if others else [f"$ORIGIN/{up}"]
    search = ":".join(f"{place}{below}" for place in places for below in LIBRARY_FOLDERS)
    subprocess.run([*patch, "--set-interpreter", home / loader_of(folder), "--force-rpath", "--set-rpath", search,
                    folder / program], check=True)
    (folder / HOME).write_text(str(home))


def shed_weight(folder):
    """Drops what no program reads, and adds the list of fonts for machines without one."""
    for unneeded in ("usr/share/doc", "usr/share/man", "usr/share/locale", "usr/share/lintian"):
        shutil.rmtree(folder / unneeded, ignore_errors=True)
    (folder / "fonts.conf").write_text(FONTS)


def wrappers(folder):
    """The scripts {name: text} for Godot, the X server and its helpers, to lie in a folder beside `folder`."""
    libraries = libraries_of(folder)
    places = ("usr/share/X11/xkb", "usr/share/xkeyboard-config-2")
    xkb = next(path for path in places if (folder / path / "rules").is_dir())
    home = shlex.quote((folder / HOME).read_text())
    search = ":".join("$lib" + below for below in LIBRARY_FOLDERS)
    texts = {}
    for program, prepare, options in (("godot", DRAWING.replace("@XKB@", xkb).replace("@HOME@", home), ""),
                                      ("Xvfb", XVFB, f'-xkbdir "$root/{xkb}" '),
                                      ("xkbcomp", "", f'-I"$root/{xkb}" '),
                                      ("matchbox-window-manager", "", "")):
        text = WRAPPER
        for name, value in (("LIBRARIES", libraries), ("LOADER", loader_of(folder)), ("PATH", search),
                            ("PREPARE", prepare), ("PROGRAM", program), ("OPTIONS", options)):
            text = text.replace(f"@{name}@", str(value))
        texts[program] = text
    return texts


def write_programs(texts, folder):
    """Writes the scripts {name: text} into `folder`."""
    for name, text in texts.items():
        (folder / name).write_text(text)
        (folder / name).chmod(0o755)
