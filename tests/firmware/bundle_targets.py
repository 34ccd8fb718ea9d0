"""What the device bundle is compiled for, and how its programs are linked and run there."""
import hashlib
import pathlib
import re
import shlex
import subprocess
from typing import NamedTuple

HERE = pathlib.Path(__file__).resolve().parent
WARNINGS = ("-Wall", "-Wextra", "-Werror")
SEMIHOSTING = ("-display", "none", "-monitor", "none", "-serial", "none", "-semihosting-config",
               "enable=on,target=native", "-kernel")
NODE = """
const [file] = process.argv.slice(1);
const module = new WebAssembly.Module(require('fs').readFileSync(file));
let text = '';
const put = at => {
  const bytes = new Uint8Array(instance.exports.memory.buffer);
  text += Buffer.from(bytes.subarray(at, bytes.indexOf(0, at))).toString('latin1');
};
const instance = new WebAssembly.Instance(module, {env: {put}});
const code = instance.exports.program();
process.stdout.write(text);
process.exit(code);
"""


class Failed(Exception):
    """A command that did not do what it should; its words."""


def run(command, **more):
    command = [str(word) for word in command]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          timeout=500, check=False, **more)
    if done.returncode != 0:
        raise Failed(f"{shlex.join(command)}\nended with {done.returncode}: {done.stdout}{done.stderr}")
    return done


class Target(NamedTuple):
    """`compiler` is which of the README's commands is taken; `machine` its flags, if not these."""
    name: str
    title: str
    compiler: str
    machine: tuple = ()
    extra: tuple = ()  # what else the compiler is told
    borrows: bool = False  # it has no headers of C and C++, and reads those that the README says
    common: tuple = ("desktop",)  # what a program is linked with, beside text
    link: tuple = ()
    emulator: tuple = ()
    precisions: tuple = ("float", "double")
    instead: str = ""  # another compiler


def arm(name, title, machine, board, precisions):
    return Target(name, title, "arm-none-eabi-g++", machine, common=("device", "runtime"),
                  link=("-nostdlib", "-T", HERE / "mps2.ld", "-Wl,--no-warn-rwx-segments", "-lgcc"),
                  emulator=("qemu-system-arm", "-M", board, *SEMIHOSTING), precisions=precisions)


X86_64 = Target("x86_64", "x86-64, gcc", "g++")
# Not every kernel runs programs of 32 bits, so an emulator does.
M32 = Target("m32", "x86 of 32 bits with SSE2, gcc", "g++", ("-m32", "-msse2", "-mfpmath=sse"),
             emulator=("qemu-i386",))
M3 = arm("m3", "Cortex-M3, float in software", ("-mcpu=cortex-m3", "-mthumb", "-mfloat-abi=soft"),
         "mps2-an385", ("float",))
M4F = arm("m4f", "Cortex-M4F", (), "mps2-an386", ("float",))
M7 = arm("m7", "Cortex-M7", ("-mcpu=cortex-m7", "-mthumb", "-mfpu=fpv5-d16", "-mfloat-abi=hard"),
         "mps2-an500", ("float", "double"))
RISCV = Target("riscv", "RISC-V, rv32imafdc", "riscv64-unknown-elf-g++", borrows=True,
               common=("riscv", "runtime"),
               link=("-nostdlib", "-T", HERE / "virt.ld", "-Wl,--no-warn-rwx-segments", "-lgcc"),
               emulator=("qemu-system-riscv32", "-M", "virt", "-bios", "none", *SEMIHOSTING))
CLANG = Target("clang", "x86-64, clang", "g++", instead="clang++")
WASM = Target("wasm", "WebAssembly, clang and node", "g++", ("--target=wasm32-wasi",), instead="clang++",
              common=("runtime",), emulator=("node", "-e", NODE),
              link=("-nostdlib", "-Wl,--no-entry", "-Wl,--export=program", "-Wl,--allow-undefined"))
IN_BUNDLE_TEST = (M32, M3, M4F, RISCV)
ALL = (X86_64, CLANG, M32, M3, M4F, M7, RISCV, WASM)


class Bundle:
    """A bundle in `folder`, and what is compiled of it in `work`; kept until one of its files changes."""

    def __init__(self, folder, work):
        self.folder, self.work = folder, work
        work.mkdir(parents=True, exist_ok=True)
        page = (folder / "README.md").read_text()
        self.borrowed = " ".join(re.findall(r"-isystem /[^\s`]*", page)).split()
        blocks = re.findall(r"```sh\n(.*?)```", page, re.S)
        self.here = blocks[-1]
        commands = [shlex.split(line) for block in blocks
                    for line in block.replace("\\\n", " ").splitlines()]
        self.commands = {words[0]: words for words in commands if "lcpush.cpp" in words}

    def files(self):
        return {path.relative_to(self.folder): path.read_bytes()
                for path in self.folder.rglob("*") if path.is_file()}

    def compile_words(self, target):
        """The README's command for the library, from elsewhere."""
        words = self.commands[target.compiler]
        if target.machine:
            words = [word for word in words if not word.startswith("-m")]
        words = [target.instead or words[0], *target.machine, *words[1:]]
        end = words.index("-c")
        words = [f"-I{self.folder}/include" if word == "-Iinclude" else word for word in words[:end]]
        return [*words, *self.headers(target), *WARNINGS]

    def headers(self, target):
        return [*(self.borrowed if target.borrows else ()), *target.extra]

    def machine_words(self, target):
        return [word for word in self.compile_words(target) if word.startswith(("-m", "--target"))]

    def foreign_headers(self, target):
        """What is read from outside of the bundle and is neither the compiler's nor a library's."""
        words = self.compile_words(target)
        allowed = [pathlib.Path(line.strip()).resolve()
                   for line in run([*words, "-x", "c++", "-E", "-v", "/dev/null"]).stderr
                   .split("search starts here:")[-1].split("End of search list")[0].splitlines()
                   if line.startswith(" ") and str(self.folder) not in line]
        rule = run([*words, "-M", self.folder / "lcpush.cpp"]).stdout.replace("\\\n", " ")
        for word in re.split(r"(?<!\\)\s+", rule)[1:]:
            path = pathlib.Path(word.replace("\\ ", " "))
            if not word or path.resolve().is_relative_to(self.folder.resolve()):
                continue
            standard = any(path.resolve().is_relative_to(folder) for folder in allowed)
            if not standard or re.search(r"Eigen|lcpush", str(path)):
                yield f"{target.title}: {path} is read"

    def library(self, target):
        """lcpush.o for a target."""
        made = self.work / f"lcpush.{target.name}.o"
        key_file = made.with_suffix(".key")
        words = [*self.compile_words(target), "-c", self.folder / "lcpush.cpp", "-o", made]
        version = run([words[0], "--version"]).stdout
        read = [(name, text) for name, text in sorted(self.files().items())
                if name.suffix in (".cpp", ".h", ".hpp", "")]
        key = hashlib.sha256(repr((version, words, read)).encode()).hexdigest()
        if not made.exists() or not key_file.exists() or key_file.read_text() != key:
            key_file.unlink(missing_ok=True)
            run(words)
            key_file.write_text(key)
        return made

    def object_of(self, target, source, name, *flags):
        """An object of C, or of C++, for a target."""
        made = self.work / f"{name}.{target.name}.o"
        compiler = self.compile_words(target)[0]
        language = ("-std=c++17", "-fno-exceptions", "-fno-rtti") if source.suffix == ".cpp" else ("-std=c99",)
        if source.suffix == ".c":
            compiler = compiler.replace("clang++", "clang").replace("g++", "gcc")
        if target.common != ("desktop",):
            flags = ("-ffreestanding", *flags)
        if source.stem == "runtime" and "clang" not in compiler:  # or gcc makes memset of its loop
            flags = ("-fno-tree-loop-distribute-patterns", *flags)
        run([compiler, *self.machine_words(target), *language, *self.headers(target), "-Os", "-ffp-contract=off",
             "-ffunction-sections", "-fdata-sections", *WARNINGS, f"-I{self.folder}/include", f"-I{HERE}",
             *flags, "-c", source, "-o", made])
        return made

    def program(self, target, name, objects, *link):
        common = [self.object_of(target, HERE / f"{part}.c", f"{name}.{part}", "-fno-builtin")
                  for part in target.common]
        made = self.work / f"{name}.{target.name}"
        compiler = self.compile_words(target)[0].replace("clang++", "clang").replace("g++", "gcc")
        run([compiler, *self.machine_words(target), *objects, *common, self.library(target),
             "-Wl,--gc-sections", *target.link, *link, "-o", made])
        return made

    def lines_of(self, target, program):
        done = run([*target.emulator, program])
        lines = (done.stdout + done.stderr).splitlines()
        if lines[-1:] != ["end"]:
            raise Failed(f"{program.name} printed {lines[-3:]}")
        return lines

    def run_example(self, target):
        objects = [self.object_of(target, self.folder / "main.c", "main", "-Dmain=example", "-ffreestanding"),
                   self.object_of(target, HERE / "bundle_main.c", "bundle_main", "-Dmain=program"
                                  if target is WASM else "-DEXAMPLE"),
                   self.object_of(target, HERE / "text.c", "example.text")]
        return self.lines_of(target, self.program(target, "example", objects))

    def hundred(self, target, precision, planted=None, wrapped=""):
        """{key: text} of all hundred."""
        name = f"hundred_{precision}" + ("_planted" if planted else "")
        flags = ["-DFIRMWARE_DOUBLE"] if precision == "double" else []
        if target is WASM:
            flags.append("-Dmain=program")
        objects = [self.object_of(target, HERE / "hundred.c", name, *flags),
                   self.object_of(target, HERE / "text.c", f"{name}.text", *flags)]
        link = []
        if planted:
            objects.append(self.object_of(target, planted, f"{name}.fault", *flags))
            link = [f"-Wl,--wrap={wrapped}"]
        for line in self.lines_of(target, self.program(target, name, objects, *link)):
            words = line.split()
            if words[:2] == ["run", "all"]:
                return dict(zip(words[2::2], words[3::2]))
        raise Failed(f"{name} says nothing")

    def as_the_readme_says(self):
        """The README's last commands, in the bundle itself; what they print."""
        library = self.library(X86_64)
        compile_lines = [line for line in self.here.replace("\\\n", " ").splitlines()
                         if "lcpush.cpp" not in line]
        (self.folder / "lcpush.o").write_bytes(library.read_bytes())
        try:
            return run(["sh", "-ec", "\n".join(compile_lines)], cwd=self.folder).stdout
        finally:
            for name in ("lcpush.o", "push"):
                (self.folder / name).unlink(missing_ok=True)
