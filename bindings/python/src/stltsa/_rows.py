# SPDX-License-Identifier: BSD-3-Clause
# Made by scripts/generate-bindings: do not edit.
"""The rows of lists. Unknown numbers are NaN."""

# ruff: noqa: D205 (the header's comments)
from __future__ import annotations

from typing import Annotated, Any, NamedTuple, TypeAlias

__all__ = [
    "Bounded",
    "Compared",
    "ComparedMotion",
    "ComparedPart",
    "Component",
    "DenoisedColumn",
    "Estimate",
    "Event",
    "FileEvent",
    "Joint",
    "Part",
    "PieceFact",
    "Seam",
    "Segment",
    "Statistics",
    "Summary",
    "Unit",
    "WarningFact",
]

FeaturesKind: TypeAlias = Annotated[str, "STLTSA_FEATURES_"]
SegmentKind: TypeAlias = Annotated[str, "STLTSA_SEGMENT_"]
UnitKind: TypeAlias = Annotated[str, "STLTSA_UNIT_"]
WarningKind: TypeAlias = Annotated[str, "STLTSA_WARNING_"]


class WarningFact(NamedTuple):
    """A warning.

    Attributes
    ----------
    code : str
        "follows-time", "rank-deficient", "small-gap", "unscaled", "inaccurate", "disconnected",
        "jump", "separate-motion", "offsets-differ", "resampled", "seam-posture", "seam-speed",
        "seam-acceleration", "not-blended", "no-order", "linear-phase", "several-places",
        "not-found", "few-cycles", "not-alike", "uncertain-shift", "sizes-differ".
    text : str
        What it is about, and what to do.
    begin_s : float
        Seconds in the clip at which it applies; NaN: it has no time.
    end_s : float
        The end, or the begin of a moment; NaN: it has no time.
    """

    code: WarningKind
    text: str
    begin_s: float
    end_s: float


class Joint(NamedTuple):
    """A joint or an end site of a skeleton.

    Attributes
    ----------
    name : str
        Not empty.
    parent : int
        Index of an earlier joint; -1: the root, which is joint 0.
    offset : tuple[float, float, float]
        From the parent, in the parent's axes; unit of the clip.
    channels : str | None
        Its values in each frame, in order: tx ty tz positions, which replace the offset (+tx +ty
        +tz add to it), rx ry rz angles in degrees about moving axes, of which the first is the
        leftmost matrix. "": none. None, as input: rz rx ry, for the root after tx ty tz, none for
        end sites; as output: those of an ASF file, which this cannot describe.
    is_end_site : bool
        The end of a chain, without rotation.
    """

    name: str
    parent: int
    offset: tuple[float, float, float]
    channels: str | None
    is_end_site: bool


class FileEvent(NamedTuple):
    """Something that the file says happens, such as a foot strike in C3D.

    Attributes
    ----------
    label : str
        "Foot Strike".
    context : str
        What it happens to, such as "Left"; may be "".
    frame : float
        Of the clip, not rounded; may lie outside it.
    seconds : float
        From the first frame of the clip; NaN if the rate is unknown.
    """

    label: str
    context: str
    frame: float
    seconds: float


class Component(NamedTuple):
    """A connected component of the neighborhood graph of a fit.

    Attributes
    ----------
    frames : int
        Distinct rows.
    residual : float
        Largest ||B u - lambda u|| / k.
    error_estimate_rad : float
        Estimate of the largest principal angle to the exact embedding.
    gap : float
        Lambda_{d+2} / lambda_{d+1}; near 1: the curve is ill-defined.
    rank_deficient_windows : int
        Windows of fewer than d directions.
    solves : int
        Applications of the inverse operator by ARPACK.
    """

    frames: int
    residual: float
    error_estimate_rad: float
    gap: float
    rank_deficient_windows: int
    solves: int


class Unit(NamedTuple):
    """A unit, [begin, end).

    Attributes
    ----------
    kind : str
        "preparing", "initial", "cyclic", "final", "wind-up", "action", "hold".
    segment : int
        Index of its segment.
    begin, end : int
        Frames, rounded.
    begin_s, end_s : float
        Seconds, with fractions of a frame.
    """

    kind: UnitKind
    segment: int
    begin: int
    end: int
    begin_s: float
    end_s: float

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Segment(NamedTuple):
    """A stretch of one behavior, [begin, end).

    Attributes
    ----------
    kind : str
        "cyclic", "repetitions", "action", "rest".
    label : str
        The label as it is shown: A, B, ... Z, AA, ...; "" for a rest.
    likeness : float
        Mean likeness to the others of its label, 0 to 1; NaN: none.
    begin, end : int
        Frames, rounded.
    begin_s, end_s : float
        Seconds, with fractions of a frame.
    period_s : float
        Median length of the cycles; NaN: not cyclic.
    candidate_period_s : float
        A period that was seen but is not claimed; NaN: none.
    number : int
        Cycles or repetitions; 1 for an action, 0 for a rest.
    carried_by : tuple[str, ...]
        Names of the joints, markers or columns that carry half of the motion, those that move most
        first.
    open_begin, open_end : bool
        The clip begins, or ends, within this motion.
    confidence : float
        Share of such answers that are right, 0 to 1.
    begin_confidence : float
        The same of the border at its begin; NaN for the first.
    reason : str
        Why it has no cycles, with the numbers; "" if it has. Of a rest: "nothing recorded" if most
        of the body is missing.
    first_step_share : float
        Share of a cycle that the first step takes; exactly 0.5 if the estimate cannot be told from
        it; NaN: no steps.
    first_step_margin : float
        Half of its 95 % interval; NaN: no steps, or under three cycles.
    steps_reason : str
        Why its cycles have no steps; "" if they have, or no cycles.
    """

    kind: SegmentKind
    label: str
    likeness: float
    begin: int
    end: int
    begin_s: float
    end_s: float
    period_s: float
    candidate_period_s: float
    number: int
    carried_by: tuple[str, ...]
    open_begin: bool
    open_end: bool
    confidence: float
    begin_confidence: float
    reason: str
    first_step_share: float
    first_step_margin: float
    steps_reason: str

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Part(NamedTuple):
    """A cycle, a step or a repetition, [begin, end), and how the body (its root, or the mean of
    points) travels over the ground meanwhile.

    Attributes
    ----------
    segment : int
        Index of its segment.
    cycle : int
        Of a step, index of its cycle; else -1.
    label : str
        Of its segment.
    begin, end : int
        Frames, rounded.
    begin_s, end_s : float
        Seconds, with fractions of a frame.
    side : int
        Which side of the body leads: 0 or 1, the same in all clips of a skeleton, by the file's
        foot strikes if it has any; -1: unknown.
    side_name : str
        "left" or "right"; "" if no names tell.
    likeness : float
        How like the others of its segment, 0 to 1; NaN: unknown.
    confidence : float
        Share of such answers that are right, 0 to 1.
    path_length : float
        In the unit of the file, as the next two; NaN: unknown.
    stride : float
        Distance between the ends of the path; NaN: unknown.
    speed : float
        Path length / second; NaN: unknown.
    turn_deg : float
        Degrees, counterclockwise as seen from above; NaN: unknown.
    """

    segment: int
    cycle: int
    label: str
    begin: int
    end: int
    begin_s: float
    end_s: float
    side: int
    side_name: str
    likeness: float
    confidence: float
    path_length: float
    stride: float
    speed: float
    turn_deg: float

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.end_s - self.begin_s


class Statistics(NamedTuple):
    """Of one quantity of several parts; all are NaN if count is 0.

    Attributes
    ----------
    number : int
        Parts.
    mean, sd : float
        Mean; standard deviation, 0 for one part.
    cv : float
        Sd / mean; NaN of turns.
    trend : float
        Relative change per minute; NaN of turns.
    """

    number: int
    mean: float
    sd: float
    cv: float
    trend: float


class Summary(NamedTuple):
    """Of the cycles or repetitions of one label.

    Attributes
    ----------
    label : str
        The label as it is shown.
    number : int
        Cycles or repetitions.
    cycles_per_min : float
        60 / mean cycle time.
    cycle_time_s : Statistics
        Lengths of the cycles.
    steps_per_min : float
        NaN without steps.
    step_time_s : Statistics
        Lengths of the steps.
    step_time_side_0_s, step_time_side_1_s : float
        Means of each side; NaN without steps.
    path_length, stride, speed, turn_deg : Statistics
        Of the cycles: see `Part`.
    """

    label: str
    number: int
    cycles_per_min: float
    cycle_time_s: Statistics
    steps_per_min: float
    step_time_s: Statistics
    step_time_side_0_s: float
    step_time_side_1_s: float
    path_length: Statistics
    stride: Statistics
    speed: Statistics
    turn_deg: Statistics


class Event(NamedTuple):
    """A moment that was found, or a mark of the caller.

    Attributes
    ----------
    frame : float
        Of the file, not rounded.
    seconds : float
        Its time.
    cycle : int
        Index among the cycles of the clip; -1: outside cycles.
    confidence : float
        0 to 1: ranks the events by the size of their likely errors.
    marked : bool
        A mark of the caller, as it was given.
    """

    frame: float
    seconds: float
    cycle: int
    confidence: float
    marked: bool


class Estimate(NamedTuple):
    """A quantity of both mean cycles and its difference, with a 95 % confidence interval from the
    spread between cycles: how well the mean of these cycles is known (docs/answers.md). Of 20
    differences that are really zero, about one is significant by chance. Unknown values are NaN.

    Attributes
    ----------
    first, first_sd : float
        Of the first motion: value, standard deviation between cycles.
    second, second_sd : float
        The same of the second.
    difference : float
        Second minus first.
    standard_error : float
        Of the difference.
    low, high : float
        Its confidence interval.
    significant : bool
        The interval excludes 0, by more than rounding.
    """

    first: float
    first_sd: float
    second: float
    second_sd: float
    difference: float
    standard_error: float
    low: float
    high: float
    significant: bool


class Bounded(NamedTuple):
    """An estimate without its parts.

    Attributes
    ----------
    value : float
        What is estimated.
    low, high : float
        Its 95 % confidence interval.
    """

    value: float
    low: float
    high: float


class Compared(NamedTuple):
    """About a whole comparison.

    Attributes
    ----------
    sides : bool
        Left against right.
    features : str
        "positions", "rotations6d", "euler", "raw", "points" that were compared.
    samples : int
        Of each cycle.
    shift : float
        Phase of the second motion at phase 0 of the first, -0.5 to 0.5.
    shift_error : float
        Its standard error; NaN: it is half a cycle by definition.
    shift_low, shift_high : float
        Its 95 % confidence interval.
    likeness : float
        Correlation of the two mean cycles; below 0.6 there is a warning.
    runner_up : float
        The same at the next best shift; NaN: there is none.
    turn_deg : float
        Degrees by which the second body was turned about the up axis to face as the first does; 0
        for skeletons with the same joints.
    size_ratio : float
        Size of the second body divided by that of the first; NaN: unknown.
    cycle_time_s : Estimate
        Mean length of the cycles.
    judged : int
        Number of lags and amplitudes of parts that have an interval.
    significant : int
        How many of them are significant.
    expected_by_chance : float
        How many would be if nothing differed.
    """

    sides: bool
    features: FeaturesKind
    samples: int
    shift: float
    shift_error: float
    shift_low: float
    shift_high: float
    likeness: float
    runner_up: float
    turn_deg: float
    size_ratio: float
    cycle_time_s: Estimate
    judged: int
    significant: int
    expected_by_chance: float


class ComparedMotion(NamedTuple):
    """One of the two motions.

    Attributes
    ----------
    path : str
        Of the clip; "": from memory.
    frames : int
        Of the clip.
    fps : float
        Of the clip; NaN: unknown.
    label : str
        The label as it is shown.
    cycles : int
        Cycles that were compared.
    cycles_per_min : float
        60 / mean cycle time.
    left_out : tuple[str, ...]
        Names that the other clip lacks.
    """

    path: str
    frames: int
    fps: float
    label: str
    cycles: int
    cycles_per_min: float
    left_out: tuple[str, ...]


class ComparedPart(NamedTuple):
    """A joint, a point or a column of the file (part), or one of its coordinates (channel). Lengths
    and angles are in the unit of the features.

    Attributes
    ----------
    part : int
        Index of the part; of a channel, of the part it belongs to.
    first : str
        Its name in the first motion.
    second : str
        Its name in the second; they differ for left and right.
    axis : str
        Of a channel, such as "x" of a position, "rz" of an angle, "1" to "6" of a rotation matrix;
        "" for the only one of a part, and of parts.
    mean : Estimate
        Mean over the cycle; NaN for a part with several channels.
    lag : Estimate
        How much later the second motion does the same, relative to the whole body (left and right:
        to half a cycle), as a share of the cycle; first is 0. NaN: the curves are not alike
        (correlation below 0.7).
    lag_s : Bounded
        The same in seconds, for the mean of both cycle times.
    amplitude : Estimate
        Of the mean curve: largest distance between two of its points; of one channel, maximum minus
        minimum.
    amplitude_ratio : Bounded
        Amplitude of the second divided by that of the first.
    rms_difference : float
        Root mean square, over the cycle, of second minus first.
    rms_by_chance : float
        The same, expected from the spread between cycles alone.
    correlation : float
        Of the two mean curves after the lag is removed.
    """

    part: int
    first: str
    second: str
    axis: str
    mean: Estimate
    lag: Estimate
    lag_s: Bounded
    amplitude: Estimate
    amplitude_ratio: Bounded
    rms_difference: float
    rms_by_chance: float
    correlation: float


class DenoisedColumn(NamedTuple):
    """One column of a denoising.

    Attributes
    ----------
    gamma : float
        Threshold that was used.
    shift : float
        D_t: mean distance of the points beyond gamma.
    noise : float
        Robust standard deviation of the residuals.
    noise_share : float
        Noise as a share of the range of the curve.
    degrees_of_freedom : float
        Effective, of the curve.
    moved : int
        Points that were moved.
    """

    gamma: float
    shift: float
    noise: float
    noise_share: float
    degrees_of_freedom: float
    moved: int


class Seam(NamedTuple):
    """The place at which one piece is followed by another, or by its own repetition.

    Attributes
    ----------
    frame : int
        First frame of the later piece; of a wrap, the number of frames.
    time_s : float
        Its time.
    piece, next : int
        Indices of the pieces that meet.
    cut_end : int
        The earlier piece ends before this frame of its clip, as resampled.
    cut_begin : int
        The later piece starts at this frame of its clip.
    crossfade : int
        Frames to each side that are blended; 0: none.
    crossfade_s : float
        The same in seconds.
    posture : float
        Distance of postures and velocities at the cuts, divided by the usual distance between
        repetitions of the same motion.
    step : float
        Largest pose step near the seam, divided by the 95th percentile in the pieces; invisible up
        to 1.
    acceleration : float
        The same of the second difference.
    wrap : bool
        The wrap of a loop.
    """

    frame: int
    time_s: float
    piece: int
    next: int
    cut_end: int
    cut_begin: int
    crossfade: int
    crossfade_s: float
    posture: float
    step: float
    acceleration: float
    wrap: bool


class PieceFact(NamedTuple):
    """What a piece was made of.

    Attributes
    ----------
    path : str
        Of its clip; "": from memory.
    begin, end : int
        Its frames there, [begin, end).
    repeat : int
        How often it is played.
    """

    path: str
    begin: int
    end: int
    repeat: int


# The C names of members that are called otherwise here.
IN_C = {"number": "count", "label": "letters"}
# The struct and the class of each list.
LISTS: dict[str, tuple[str, type[Any]]] = {
    "warning": ("stltsa_warning", WarningFact),
    "joint": ("stltsa_joint", Joint),
    "file_event": ("stltsa_file_event", FileEvent),
    "component": ("stltsa_component", Component),
    "unit": ("stltsa_unit", Unit),
    "segment": ("stltsa_segment", Segment),
    "cycle": ("stltsa_part", Part),
    "step": ("stltsa_part", Part),
    "repetition": ("stltsa_part", Part),
    "summary": ("stltsa_summary", Summary),
    "event": ("stltsa_event", Event),
    "comparison": ("stltsa_compared", Compared),
    "motion": ("stltsa_compared_motion", ComparedMotion),
    "part": ("stltsa_compared_part", ComparedPart),
    "part_channel": ("stltsa_compared_part", ComparedPart),
    "column": ("stltsa_denoised_column", DenoisedColumn),
    "seam": ("stltsa_seam", Seam),
    "piece": ("stltsa_piece_fact", PieceFact),
}
