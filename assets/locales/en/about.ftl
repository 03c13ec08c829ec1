### The screen that tells what the game is and whose work is in it. { $value } is a name, often with a version.

menu-about = About
about-game = Antipode is a game of walking, digging and building in hyperbolic, spherical and flat space.
about-version = Version: { $value }
about-adapter = Graphics: { $value }
about-driver = Driver: { $value }
about-system = System: { $value }
about-built-with = Built with: { $value }

about-licences = Licences
about-licence-own = Antipode, its sounds and its icon are free under the MIT licence or the Apache licence 2.0, as you choose.
about-licence-fonts = Fonts: Noto Sans SC and Noto Emoji (SIL Open Font License 1.1), Ubuntu Light (Ubuntu Font Licence 1.0), Hack (MIT and Bitstream Vera), egui's icons (MIT).
about-licence-parts = { $count ->
    [one] One part by others is built in. The full text of its licence is in the file THIRD-PARTY.txt beside the game.
   *[other] { $count } parts by others are built in. The full texts of their licences are in the file THIRD-PARTY.txt beside the game.
}
