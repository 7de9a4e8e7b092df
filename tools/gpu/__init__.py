"""What the shaders cost on a graphics card, by the compiler of Mesa's driver for AMD cards, without a card."""
