# SPDX-License-Identifier: BSD-3-Clause
"""Python gives the right answer to the recordings of tests/command/cases.py."""

import json
import sys

import pytest
from conftest import ROOT

import stltsa

sys.path.append(str(ROOT / "tests" / "command"))
import cases


@pytest.mark.filterwarnings("ignore::stltsa.QualityWarning")  # of noise, which has no order
@pytest.mark.parametrize("name", cases.CASES)
def test_case(name, tmp_path):
    write, right = cases.CASES[name]
    path = write(tmp_path)
    if right.error is not None:
        with pytest.raises(stltsa.StltsaError) as raised:
            stltsa.decompose(path)
        assert right.error in str(raised.value)
        return
    clip = stltsa.read_clip(path)
    for result in (stltsa.decompose(clip), stltsa.decompose(path)):
        cases.check(right, json.loads(result.to_json()), json.loads(clip.to_json()))
