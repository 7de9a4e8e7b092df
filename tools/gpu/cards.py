"""The graphics cards of the estimate, and its formula."""

import dataclasses

WAVE = 64  # Vertices for which the compiler states its cycles.


@dataclasses.dataclass(frozen=True)
class Card:
    family: str  # Mesa's name of the chip.
    title: str
    simds: int
    clock: float  # Hz

    def milliseconds(self, vertices, cycles):
        """The time of all SIMDs for `vertices`, if each wave of 64 takes `cycles` of one SIMD and no SIMD waits."""
        return 1000.0 * vertices * cycles / WAVE / (self.simds * self.clock)


CARDS = (
    Card("vangogh", "Steam Deck", simds=8 * 2, clock=1.6e9),
    Card("navi33", "Radeon RX 7600", simds=32 * 2, clock=2.25e9),
)
