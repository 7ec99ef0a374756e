# SPDX-License-Identifier: BSD-3-Clause
"""The sets of measure/behaviors."""
