"""What the checker's last stage accepts is true: Coq accepts the proof, without an axiom, and refuses it where
the checker would look at less.

    python3 tests/certify/test_proof.py COQC docs/check/certificate.v
"""

import pathlib
import re
import subprocess
import sys
import tempfile

# What the checker asks -> what a careless one would.
CARELESS = {
    "Qeq_bool (Qmin (x i) (w i)) 0": "Qeq_bool (x i * w i) 0",
    "free i || Qle_bool 0 (y i)": "true || Qle_bool 0 (y i)",
    "negb (Qle_bool 0 (dot all y q))": "negb (Qle_bool 1 (dot all y q))",
    "if free j then Qabs (gain j) else gain j": "gain j",
    "negb (Qle_bool 0 (dot rows y q))": "negb (Qle_bool 1 (dot rows y q))",
    "Qle_bool (taken i + mu c * taken j) 0)": "Qle_bool (taken i) 0)",
    "forallb (fun j => Qle_bool (taken j) 0) smooth": "true",
    "exists j, In j (frictions c) /\\ 0 <= taken j": "exists j, In j (frictions c)",
}


def accepted(coqc, proof):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "certificate.v")
        path.write_text(proof)
        result = subprocess.run([coqc, path], capture_output=True, text=True, timeout=100)
    return result.returncode == 0, result.stdout + result.stderr


def main():
    coqc, path = sys.argv[1:]
    proof = pathlib.Path(path).read_text()
    good, words = accepted(coqc, proof)
    theorems = len(re.findall(r"^Theorem", proof, re.MULTILINE))
    if not good or words.count("Closed under the global context") != theorems or theorems == 0:
        sys.exit(f"not proved, or with an axiom:\n{words}")
    for asked, careless in CARELESS.items():
        if proof.count(asked) != 1:
            sys.exit(f"{asked!r} stands {proof.count(asked)} times in {path}")
        if accepted(coqc, proof.replace(asked, careless))[0]:
            sys.exit(f"Coq also accepts {careless!r} in the place of {asked!r}")
    print(f"{theorems} theorems proved; {len(CARELESS)} careless checkers are not")


main()
