// SPDX-License-Identifier: BSD-3-Clause
//! The library's enumerations. A value that is newer than this crate is `Other`.

use std::fmt;

use stltsa_sys as sys;

macro_rules! kinds {
    ($($(#[$text:meta])* $name:ident { $($(#[$what:meta])* $variant:ident = $value:ident,)* })*) => {$(
        $(#[$text])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$what])* $variant,)*
            /// A value that this version of the crate does not know.
            Other(i32),
        }

        impl $name {
            #[allow(dead_code)] // some are only asked for, some only answered
            pub(crate) fn from_raw(value: i32) -> Self {
                match value {
                    $(sys::$value => Self::$variant,)*
                    other => Self::Other(other),
                }
            }

            #[allow(dead_code)]
            pub(crate) fn raw(self) -> i32 {
                match self {
                    $(Self::$variant => sys::$value,)*
                    Self::Other(other) => other,
                }
            }
        }
    )*};
}

kinds! {
    /// Where neighbors of a frame are looked for.
    Mode {
        /// Among the frames of its clip within the window.
        Temporal = STLTSA_MODE_TEMPORAL,
        /// Among all frames. Needs a library with CHOLMOD.
        Spatial = STLTSA_MODE_SPATIAL,
        /// Within the window and, as links, among all frames outside the exclusion zone. Needs a
        /// library with CHOLMOD.
        Recurrent = STLTSA_MODE_RECURRENT,
    }

    /// What a pose is described by.
    Features {
        /// Positions where there is a skeleton, else the file's numbers.
        Auto = STLTSA_FEATURES_AUTO,
        /// Joints and end sites, root position and yaw removed.
        Positions = STLTSA_FEATURES_POSITIONS,
        /// Two columns of each rotation matrix, root yaw removed.
        Rotations6d = STLTSA_FEATURES_ROTATIONS6D,
        /// The angles below the root in radians, unwrapped (as in the paper).
        Euler = STLTSA_FEATURES_EULER,
        /// The file's numbers.
        Raw = STLTSA_FEATURES_RAW,
    }

    /// What a clip was read from.
    Format {
        /// BVH.
        Bvh = STLTSA_FORMAT_BVH,
        /// AMC, with its ASF.
        Amc = STLTSA_FORMAT_AMC,
        /// Numbers split by `,`, `;`, tab or blanks; a header line is optional.
        Csv = STLTSA_FORMAT_CSV,
        /// NumPy 1.0 to 3.0, one or two dimensions, float32 or float64.
        Npy = STLTSA_FORMAT_NPY,
        /// No file: [`Clip::from_matrix`](crate::Clip::from_matrix).
        Matrix = STLTSA_FORMAT_MATRIX,
    }

    /// Stages of the work as a progress closure sees them; a call passes through some of them.
    Stage {
        /// Reading a clip.
        Read = STLTSA_STAGE_READ,
        /// Features of its poses.
        Features = STLTSA_STAGE_FEATURES,
        /// Neighbors of each frame.
        Neighbors = STLTSA_STAGE_NEIGHBORS,
        /// Local tangents.
        Tangents = STLTSA_STAGE_TANGENTS,
        /// The alignment matrix.
        Alignment = STLTSA_STAGE_ALIGNMENT,
        /// Its smallest eigenvectors.
        Spectrum = STLTSA_STAGE_SPECTRUM,
        /// Units and cycles.
        Units = STLTSA_STAGE_UNITS,
        /// Mapping, either way.
        Map = STLTSA_STAGE_MAP,
        /// Denoising.
        Denoise = STLTSA_STAGE_DENOISE,
        /// New motion.
        Synthesis = STLTSA_STAGE_SYNTHESIS,
    }

    /// Kinds of motion units. `Display` gives the library's names: "preparing", "wind-up", ...
    UnitKind {
        /// Standing before a motion.
        Preparing = STLTSA_UNIT_PREPARING,
        /// From the first movement to the first cycle.
        Initial = STLTSA_UNIT_INITIAL,
        /// The cycles.
        Cyclic = STLTSA_UNIT_CYCLIC,
        /// From the last cycle to standing.
        Final = STLTSA_UNIT_FINAL,
        /// Standing after a motion.
        WindUp = STLTSA_UNIT_WIND_UP,
        /// Moving, and no cycle is claimed there.
        Action = STLTSA_UNIT_ACTION,
        /// One cycle of the cyclic unit.
        Cycle = STLTSA_UNIT_CYCLE,
    }
}

impl fmt::Display for UnitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // SAFETY: a static text for any number.
        f.pad(&unsafe { crate::error::text(sys::stltsa_unit_name(self.raw())) })
    }
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// x.
    X = 1,
    /// y.
    Y = 2,
    /// z.
    Z = 3,
}
