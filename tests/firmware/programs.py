"""The firmware's programs: what was built, what it prints under QEMU, what the linker made of it."""
import pathlib
import re
import struct
import subprocess

MACHINE = {"m3": "mps2-an385", "m4f": "mps2-an386", "m7d": "mps2-an500"}
PRECISION = {"m3": "float", "m4f": "float", "m7d": "double"}


class Programs:
    """What was built, and what it printed."""

    def __init__(self, args):
        self.build, self.qemu = pathlib.Path(args.build), args.qemu
        self.printed = {}

    def elf(self, program, target):
        return self.build / f"{program}.{target}.elf"

    def run(self, program, target, machine=None):
        """Lines of output; raises RuntimeError unless the program ended well."""
        elf, machine = self.elf(program, target), machine or MACHINE[target]
        command = [self.qemu, "-M", machine, "-display", "none", "-monitor", "none", "-serial",
                   "none", "-semihosting-config", "enable=on,target=native", "-icount", "shift=6",
                   "-kernel", str(elf)]
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  timeout=120)
        except subprocess.TimeoutExpired:
            raise RuntimeError(f"{elf.name} on {machine} did not end")
        return self.lines_of(done, f"{elf.name} on {machine}")

    def run_here(self, program, precision):
        command = [str(self.build / f"firmware_{program}_{precision}")]
        return self.lines_of(subprocess.run(command, capture_output=True, text=True), command[0])

    @staticmethod
    def lines_of(done, name):
        # Semihosting writes to standard error.
        lines = (done.stdout + done.stderr).splitlines()
        if done.returncode != 0 or "FAULT" in lines or "end" not in lines:
            raise RuntimeError(f"{name} failed, exit {done.returncode}: {lines[-1:]}")
        return lines

    def runs(self, program, target):
        """{name: {key: text}} of a program on a microcontroller; run once."""
        if (program, target) not in self.printed:
            self.printed[program, target] = table(self.run(program, target))
        return self.printed[program, target]

    def runs_here(self, program, precision):
        return table(self.run_here(program, precision))

    def tool(self, name, *arguments):
        return subprocess.run([f"arm-none-eabi-{name}", *map(str, arguments)], check=True,
                              capture_output=True, text=True).stdout

    def symbols(self, program, target):
        return [line.split()[-1] for line in
                self.tool("nm", self.elf(program, target)).splitlines() if line.strip()]

    def sections(self, program, target):
        """{name: bytes}"""
        found = {}
        for line in self.tool("size", "-A", self.elf(program, target)).splitlines():
            words = line.split()
            if len(words) == 3 and words[0].startswith("."):
                found[words[0]] = int(words[1])
        return found

    def code_of(self, program, target, source):
        """Bytes of an object's code and constants in a program, by the linker's map."""
        total = 0
        text = pathlib.Path(f"{self.elf(program, target)}.map").read_text()
        text = text[text.index("Linker script and memory map"):]
        pattern = r"^ \.(?:text|rodata)\S*\s+0x[0-9a-f]+\s+(0x[0-9a-f]+) (\S+)$"
        for size, path in re.findall(pattern, text, re.M):
            if pathlib.Path(path).name == f"{source}.{target}.o":
                total += int(size, 16)
        if total == 0:
            raise RuntimeError(f"{source}.{target}.o is not in the map of {program}")
        return total

    def stack_usage(self, name, target):
        return (self.build / f"{name}.{target}.su").read_text().splitlines()


def table(lines):
    runs = {}
    for line in lines:
        words = line.split()
        if words[:1] == ["run"]:
            runs[words[1]] = dict(zip(words[2::2], words[3::2]))
    return runs


def instructions(ticks):
    """The timer counts 40 ns, an instruction takes 64."""
    return int(ticks) * 40 // 64


def number(bits):
    return struct.unpack(">f" if len(bits) == 8 else ">d", bytes.fromhex(bits))[0]
