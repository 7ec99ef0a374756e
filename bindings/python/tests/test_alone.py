# SPDX-License-Identifier: BSD-3-Clause
"""The package needs only NumPy: here nothing else can be imported."""

import subprocess
import sys
import textwrap

BLOCK = """
import sys
for name in ("sklearn", "pandas", "matplotlib", "tqdm", "ezc3d", "scipy"):
    sys.modules[name] = None
import numpy as np
import stltsa
"""


def run(code):
    code = BLOCK + textwrap.dedent(code)
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


def test_results_are_record_arrays(walker):
    run(f"""
        result = stltsa.decompose({str(walker)!r}, progress=True)
        assert isinstance(result.units, np.recarray)
        assert list(result.units.kind) == list(result.units["kind"])
        assert result.units.kind[0] == "preparing"
        assert result.cycles.begin.dtype == np.int64
        assert len(stltsa.synthesize([(result.clip, 0, 100)]).seams) == 0
        assert "<table>" in result._repr_html_()
    """)


def test_estimator_fits_and_maps():
    run("""
        import pickle
        t = np.linspace(0, 6 * np.pi, 300)
        X = np.column_stack([np.cos(t), np.sin(t), np.sin(t + 1)])
        ltsa = stltsa.STLTSA(n_neighbors=100)
        assert "n_neighbors=100" in repr(ltsa)
        try:
            ltsa.transform(X)
        except AttributeError as error:
            assert "not fitted" in str(error)
        else:
            raise SystemExit("transform before fit")
        coords = ltsa.fit_transform(X)
        assert (ltsa.transform(X) == coords).all()
        assert (pickle.loads(pickle.dumps(ltsa)).transform(X) == coords).all()
        assert list(ltsa.get_feature_names_out()) == ["stltsa0", "stltsa1"]
        assert ltsa.set_params(n_components=1).fit(X).embedding_.shape == (300, 1)
        for bad in (lambda: ltsa.transform(X[:, :2]), lambda: ltsa.set_params(nonsense=1)):
            try:
                bad()
            except ValueError:
                continue
            raise SystemExit("no error")
    """)


def test_extras_say_what_they_need(tmp_path):
    path = tmp_path / "a.c3d"
    run(f"""
        clip = stltsa.Clip.from_points(np.zeros((9, 4, 3)), 100)
        try:
            clip.save({str(path)!r})
        except ImportError as error:
            assert "needs ezc3d: pip install" in str(error), error
        else:
            raise SystemExit("no error")
    """)


def test_import_is_light():
    run("""
        heavy = {"sklearn", "pandas", "matplotlib", "scipy"}
        assert not {m for m in sys.modules if m in heavy and sys.modules[m] is not None}
        assert "stltsa.estimator" not in sys.modules
        assert {"STLTSA", "plot", "readers"} <= set(dir(stltsa))
    """)
