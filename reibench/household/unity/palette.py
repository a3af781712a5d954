"""Colours: what things are painted in, by type."""

from zlib import crc32

Color = tuple[int, int, int]

WOOD, DARK_WOOD, STEEL, WHITE, DARK = (
    (176, 128, 80),
    (124, 84, 52),
    (176, 184, 192),
    (236, 236, 232),
    (70, 72, 78),
)
GREEN, RED, CLOTH = (96, 160, 72), (204, 56, 44), (110, 130, 176)
OF_TYPES: tuple[tuple[Color, str], ...] = (
    (WOOD, "DiningTable SideTable CoffeeTable Desk Shelf ShelvingUnit Drawer Chair Stool Box"),
    (DARK_WOOD, "Dresser TVStand Cabinet Footstool BaseballBat Statue"),
    (STEEL, "Sink SinkBasin Faucet Toaster Pot Pan Kettle Knife ButterKnife Fork Spoon Ladle"),
    (STEEL, "Spatula ShowerHead GarbageCan Safe TowelHolder HandTowelHolder ToiletPaperHanger"),
    (WHITE, "Fridge Toilet Bathtub BathtubBasin Plate Bowl Mug Cup Egg EggCracked ToiletPaper"),
    (WHITE, "PaperTowelRoll SaltShaker LightSwitch Pillow"),
    (DARK, "Microwave CoffeeMachine Television Laptop RemoteControl CellPhone StoveBurner"),
    (DARK, "StoveKnob PepperShaker Watch Plunger"),
    ((196, 196, 200), "CounterTop"),
    (RED, "Apple AppleSliced Tomato TomatoSliced"),
    (GREEN, "Lettuce LettuceSliced HousePlant WineBottle WateringCan"),
    ((206, 160, 90), "Bread BreadSliced Potato PotatoSliced"),
    ((240, 208, 70), "DishSponge SoapBar Pencil Candle TeddyBear TennisRacket"),
    (CLOTH, "Sofa ArmChair Ottoman Bed Towel HandTowel Cloth Curtains Blinds ShowerCurtain"),
    ((226, 150, 60), "BasketBall AlarmClock SoapBottle SprayBottle"),
    ((246, 226, 168), "DeskLamp FloorLamp"),
    ((168, 206, 228), "Window Mirror ShowerDoor ShowerGlass Bottle Vase"),
    ((150, 70, 80), "Book Painting Poster"),
)
HTML: dict[str, Color] = {
    "red": (255, 0, 0), "cyan": (0, 255, 255), "blue": (0, 0, 255), "darkblue": (0, 0, 160),
    "lightblue": (173, 216, 230), "purple": (128, 0, 128), "yellow": (255, 255, 0),
    "lime": (0, 255, 0), "fuchsia": (255, 0, 255), "white": (255, 255, 255),
    "silver": (192, 192, 192), "grey": (128, 128, 128), "black": (0, 0, 0),
    "orange": (255, 165, 0), "brown": (165, 42, 42), "maroon": (128, 0, 0),
    "green": (0, 128, 0), "olive": (128, 128, 0), "navy": (0, 0, 128), "teal": (0, 128, 128),
    "aqua": (0, 255, 255), "magenta": (255, 0, 255), "default": (150, 190, 220),
}  # fmt: skip
"""Unity's names of colours."""

_BY_TYPE = {name: color for color, names in OF_TYPES for name in names.split()}


def color_of(object_type: str) -> Color:
    """Return what a type is painted in; one not listed gets a colour made of its name."""
    known = _BY_TYPE.get(object_type)
    if known:
        return known
    number = crc32(object_type.encode())
    return 90 + number % 120, 90 + (number >> 8) % 120, 90 + (number >> 16) % 120


def parse_color(text: str) -> Color:
    """Read an HTML colour that `AddThirdPartyCamera` has accepted: a name, #rgb or #rrggbb."""
    digits = text.removeprefix("#")
    if digits == text:
        return HTML[text.lower()]
    if len(digits) < 6:
        digits = "".join(2 * digit for digit in digits)
    return int(digits[0:2], 16), int(digits[2:4], 16), int(digits[4:6], 16)
