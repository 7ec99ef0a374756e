# SPDX-License-Identifier: BSD-3-Clause
"""Recordings with exact labels, and how well an answer agrees with them; run by measure/recordings."""
