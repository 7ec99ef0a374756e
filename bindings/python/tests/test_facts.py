# SPDX-License-Identifier: BSD-3-Clause
"""Facts by name agree with the properties and the JSON."""

import json

import stltsa


def test_facts_of_a_clip(clip, walker):
    facts = clip.facts
    assert facts["path"] == (str(walker),)
    assert facts["format"] == ("bvh",)
    assert facts["clip_frames"] == (len(clip),)
    assert len(facts["channel"]) == clip.channels
    assert "neighbors" not in facts


def test_facts_of_a_model(model):
    facts = model.facts
    assert (facts["neighbors"], facts["window"]) == (model.neighbors, model.window)
    assert (facts["mode"], facts["features"]) == (model.mode, "positions")
    assert [component.residual for component in facts["component"]] == [model.residual]
    assert tuple(warning.text for warning in facts["warning"]) == model.warnings
    parameters = json.loads(model.to_json())["parameters"]
    assert facts["include_self"] == int(parameters["include_self"])


def test_facts_of_results(clip, model, result, circle):
    assert result.facts["cyclicity"] == result.cyclicity
    assert result.facts["reason"] == result.reason == ""
    denoised = stltsa.denoise(model)
    assert [column.gamma for column in denoised.facts["column"]] == list(denoised.columns["gamma"])
    dimension = stltsa.dimension(circle, neighbors=110)
    assert dimension.model.facts["eigenvalue"] == tuple(dimension.eigenvalues)
    made = stltsa.synthesize([(clip, 0, 40), (clip, 40, 80)])
    assert [piece.end for piece in made.facts["piece"]] == [40, 80]
