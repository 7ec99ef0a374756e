// SPDX-License-Identifier: BSD-3-Clause
// Steady walking as curves over the gait cycle. The phase of a leg counts cycles: 0 when its heel
// lands, 0.5 when the other heel lands. Angles are in degrees. Sources: README.md.
#pragma once

namespace walker {

constexpr double toe_off = 0.62; ///< phase at which a foot leaves the floor

/// One leg, as a function of its own phase.
struct LegAngles {
    double thigh = 0;     ///< forward from the vertical
    double knee = 0;      ///< flexion
    double foot = 0;      ///< toes up from the floor
    double toes = 0;      ///< extension against the foot
    double adduction = 0; ///< of the whole leg, beyond standing
};
LegAngles leg_angles(double phase);

/// One arm, as a function of the phase of the leg on its side.
struct ArmAngles {
    double shoulder = 0; ///< flexion from the vertical
    double elbow = 0;    ///< flexion
};
ArmAngles arm_angles(double phase);

/// Pelvis and trunk, as functions of the phase of the left leg.
struct TrunkAngles {
    double pelvis_list = 0;     ///< left side up
    double pelvis_rotation = 0; ///< left side forward
    double pelvis_tilt = 0;     ///< forward, beyond standing
    double chest_list = 0;
    double chest_rotation = 0;
    double chest_tilt = 0;
};
TrunkAngles trunk_angles(double phase);

} // namespace walker
