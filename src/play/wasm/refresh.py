"""Makes the playground's solver, a WebAssembly module, from the sources and writes it as text.

    python3 src/play/wasm/refresh.py            after every change of what it is made of
    python3 src/play/wasm/refresh.py --check    exits 1 if solver.txt is not what the sources make

Debian 12: clang-14 lld-14 libc++-14-dev-wasm32 libc++abi-14-dev-wasm32 wasi-libc
libclang-rt-14-dev-wasm32 binaryen cmake ninja-build libeigen3-dev. It builds in build/solver.

solver.txt is the module, packed by LZMA, which makes it an eighth smaller than the deflate that
browsers know; four bytes as five characters of the alphabet below: a number in base 85, largest digit
first. The page's unpack.js reads it back.
"""

import lzma
import pathlib
import struct
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
BUILD = ROOT / "build" / "solver"
TEXT = HERE / "solver.txt"
# No quotes, no < > & and no backslash: it stands in C++, CMake and HTML as it is.
ALPHABET = ("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
            "!#%()*+,-./:=?@^_{|}~$;")
WIDTH = 6000
# A byte's place modulo four says nothing in a module; the byte before it does. unpack.js knows both.
PACKING = [{"id": lzma.FILTER_LZMA1, "dict_size": 1 << 20, "lc": 4, "lp": 0, "pb": 0, "nice_len": 273,
            "mf": lzma.MF_BT4, "depth": 1000}]


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in words)}\n{done.stdout}")


def build():
    run("cmake", "-S", HERE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None")
    run("cmake", "--build", BUILD)
    small = BUILD / "small.wasm"
    # lld puts nothing below address 1024. What the first round leaves, the second makes smaller still.
    run("wasm-opt", "--low-memory-unused", "-Oz", "-Oz", BUILD / "solver.wasm", "-o", small)
    return small.read_bytes()


def packed(module):
    data = lzma.compress(module, format=lzma.FORMAT_RAW, filters=PACKING)
    header = f"{len(module)} {len(data)}\n"
    data += bytes(-len(data) % 4)
    digits = []
    for (number,) in struct.iter_unpack(">I", data):
        digits += [ALPHABET[number // 85 ** k % 85] for k in (4, 3, 2, 1, 0)]
    text = "".join(digits)
    return header + "".join(f"{text[k:k + WIDTH]}\n" for k in range(0, len(text), WIDTH))


def unpacked(text):
    header, *lines = text.splitlines()
    value = {character: k for k, character in enumerate(ALPHABET)}
    digits, data = "".join(lines), bytearray()
    for k in range(0, len(digits), 5):
        number = 0
        for character in digits[k:k + 5]:
            number = 85 * number + value[character]
        data += struct.pack(">I", number)
    return lzma.decompress(bytes(data[:int(header.split()[1])]), format=lzma.FORMAT_RAW, filters=PACKING)


def main():
    module = build()
    if "--check" not in sys.argv:
        TEXT.write_text(packed(module), encoding="ascii")
    elif unpacked(TEXT.read_text(encoding="ascii")) != module:
        sys.exit(f"{TEXT.relative_to(ROOT)} is not what the sources make: run "
                 f"python3 {pathlib.Path(__file__).resolve().relative_to(ROOT)}")
    print(f"{TEXT.relative_to(ROOT)}: {len(module)} bytes, {TEXT.stat().st_size} of text")


if __name__ == "__main__":
    main()
