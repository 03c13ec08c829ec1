### The screen that tells what the game is and whose work is in it.

menu-about = 关于
about-game = Antipode 是一款在双曲、球面和平直空间中行走、挖掘和建造的游戏。
about-version = 版本：{ $value }
about-adapter = 图形：{ $value }
about-driver = 驱动：{ $value }
about-system = 系统：{ $value }
about-built-with = 构建所用：{ $value }

about-licences = 许可
about-licence-own = Antipode 及其声音和图标可任选 MIT 许可或 Apache 2.0 许可自由使用。
about-licence-fonts = 字体：Noto Sans SC 和 Noto Emoji（SIL Open Font License 1.1）、Ubuntu Light（Ubuntu Font Licence 1.0）、Hack（MIT 和 Bitstream Vera）、egui 图标（MIT）。
about-licence-parts = 内含他人编写的 { $count } 个部件。各许可全文见游戏旁的文件 THIRD-PARTY.txt。
