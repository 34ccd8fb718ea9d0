"""A folder that is a Debian with nothing but what a package depends on: its files are copied from the
packages that this machine has installed, and dpkg is told of those and of no others.
"""
import os
import pathlib
import re
import shutil
import subprocess

UNREAD = ("/usr/share/doc", "/usr/share/man", "/usr/share/locale", "/usr/share/lintian")
# What every Debian has, as far as scripts of packages need it.
ESSENTIAL = ("dash", "libc-bin")


def output(*command, **more):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, **more)
    assert result.returncode == 0, f"{command}: {result.stdout}{result.stderr}"
    return result.stdout


def as_root():
    """What goes before commands that need a root of their own; None if nothing helps."""
    if os.geteuid() == 0:
        return []
    helps = shutil.which("unshare") and subprocess.run(["unshare", "-r", "true"], check=False,
                                                       capture_output=True).returncode == 0
    return ["unshare", "-r"] if helps else None


def installed():
    """Of each package, and of what it provides: its name in dpkg, and what it depends on."""
    known = {}
    for line in output("dpkg-query", "-W", "-f", "${binary:Package}\t${db:Status-Status}\t"
                       "${Pre-Depends}, ${Depends}\t${Provides}\n").splitlines():
        name, status, depends, provides = line.split("\t")
        if status != "installed":
            continue
        for called in [name.split(":")[0], *re.findall(r"[a-z0-9][a-z0-9+.-]+(?= \(|,|$)", provides)]:
            known.setdefault(called, (name, depends))
    return known


def closure(wanted, known):
    """dpkg's names of all that `wanted`, as a field Depends has it, needs; KeyError if one of them is
    not installed here."""
    found, open_fields = {}, [wanted]
    while open_fields:
        for group in filter(None, map(str.strip, open_fields.pop().split(","))):
            choices = [re.split(r"[ (:]", choice.strip())[0] for choice in group.split("|")]
            there = [choice for choice in choices if choice in known]
            if not there:
                raise KeyError(group)
            name, depends = known[there[0]]
            if name not in found:
                found[name] = True
                open_fields.append(depends)
    return list(found)


def make(root, depends):
    """`root` becomes a Debian with ESSENTIAL and what `depends` needs."""
    names = closure(", ".join([*ESSENTIAL, depends]), installed())
    (root / "usr").mkdir(parents=True)
    for merged in ("bin", "sbin", "lib", "lib32", "lib64"):
        if pathlib.Path("/", merged).is_symlink():
            (root / "usr" / merged).mkdir()
            (root / merged).symlink_to(f"usr/{merged}")
    info = root / "var/lib/dpkg/info"
    info.mkdir(parents=True)
    (root / "var/lib/dpkg/updates").mkdir()
    (root / "tmp").mkdir()
    (root / "var/lib/dpkg/status").write_text("".join(
        output("dpkg-query", "-s", name).rstrip("\n") + "\n\n" for name in names), encoding="utf-8")
    for name in names:
        listed = output("dpkg-query", "-L", name).splitlines()
        (info / f"{name}.list").write_text("\n".join(listed) + "\n", encoding="utf-8")
        for path in map(pathlib.Path, listed):
            if str(path).startswith(UNREAD) or not os.path.lexists(path):
                continue
            copy = root / path.relative_to("/")
            if path.is_dir() and not path.is_symlink():
                copy.mkdir(parents=True, exist_ok=True)
            elif not os.path.lexists(copy):
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(path, copy, follow_symlinks=False)
    return names
