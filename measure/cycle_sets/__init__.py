# SPDX-License-Identifier: BSD-3-Clause
"""Sets of measure/cycles: made-up and recorded motion with known cycles."""
