### The backpack over the running world.

action-backpack = 背包

backpack-title = 背包
# What a slot is called, and a thing with how many there are of it.
backpack-slot = 第 { $number } 格：{ $item }
backpack-slot-empty = 第 { $number } 格：空
backpack-item = { $item } × { $count }
backpack-throw = 扔掉
backpack-close = 关闭
# The page on which things are made of ground, the way to it and back, what is carried of ground, and what a thing takes of a kind out of what is there.
backpack-make = 制作
backpack-slots = 格子
making-carried = 随身带着：
making-nothing = 你没有带任何土石。挖掘即可收集。
making-where = 煤在地下 2 米以下成层分布，铜在 4 米以下成脉分布，上方常有黏土；水晶在 7 米以下，上方有碎石，洞穴的大厅里也有。
making-earth = { $kind } { $volume } 立方米
making-part = { $kind } { $has } / { $needs } 立方米
# What the button that makes a thing is called, with what it takes.
making-recipe = 制作{ $item }：{ $parts }
# What the mouse does, and what the keys do, in a few lines.
backpack-how = 左键：拿起、放下、拖动 · 右键：拿一半、放一个 · Shift + 左键：移到另一部分 · 框外：扔掉
backpack-how-keys = 方向键：移动 · Enter：拿起、放下 · Ctrl + Enter：拿一半、放一个 · Shift + Enter：移到另一部分 · 数字键：与快捷栏交换

# What a thing does, in a sentence.
item-gun-about = 向准星所指之处射出一颗子弹。
item-bullet-about = 枪用的子弹。
item-lamp-about = 照亮周围。可以放下，也可以再拿起。
item-flag-about = 标记一个地方。插在地上，点一下就能取名，也可以再收起：地图和罗盘会指出去那里的路。
item-door-about = 成对的门之一。放好两扇：从一扇进去，就从另一扇出来。用右键收起。
item-log-about = 一段树干。可以立起来当柱子，也可以用它的木头做东西。
item-stone-about = 放下来可以搭建，也可以用它的岩石做东西。
item-seed-about = 种在松软的地里，会长成当地的树，一天天长大。
item-crumb-about = 沿路撒下：按住按钮往前走。地图和罗盘会带你沿着它们回去。
item-pickaxe-wood-about = 挖掘和建造，很慢。在采集世界里，挖不动铜和水晶。
item-pickaxe-iron-about = 挖掘和建造，速度是木镐的三倍。在采集世界里也能挖铜。
item-pickaxe-diamond-about = 挖掘和建造，速度是木镐的五倍。在采集世界里也能挖水晶。
