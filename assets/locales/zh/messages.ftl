### 提示、回答和可能出错的事。{ $path } 是文件或文件夹，{ $details } 是英文句子。

saved = 已保存

hint-map-raised = 抬升图
hint-map-horizon = 地平图
hint-no-other-map = 球面没有别的图。
hint-bent = { $up }把画面弯成双曲，{ $down }弯成球面。
hint-unbent = 画面恢复平直。
hint-no-bullets = 没有子弹了。
hint-no-place-for-lamp = 灯要放在八米以内的地面上。
hint-none-there-lamp = 准星下没有灯。
hint-too-many-lamp = 这个世界里的灯太多了，请先收起一盏。
room-hint-no-place-for-lamp = 灯要放在准星所指、八米以内的东西上。
room-hint-too-many-lamps = 这个房间自己已有八盏灯，不能再亮更多。
room-hint-nothing-to-lift = 准星所指的三米之内没有可以搬动的东西。
room-hint-too-heavy = 太重了，搬不起来；推它吧。
room-hint-fell-out = 你掉出了房间，重新开始。
room-hint-for-worlds = { $key }只用于世界。在房间里，枪、灯和球随时可用。
hint-no-place-for-flag = 旗子要插在八米以内不太陡的地上。
hint-none-there-flag = 准星下没有旗子。
hint-too-many-flag = 这个世界里的旗子太多了，请先收起一面。
hint-no-place-for-log = 原木要立在八米以内的空地上。
hint-no-place-for-stone = 石头要放在八米以内的空地上。
hint-no-place-for-seed = 种子要种在八米以内松软平坦、上面没有遮挡、离别的树一步以外的地里。
hint-no-place-for-crumb = 面包屑要放在八米以内的地上。
hint-none-there-crumb = 准星下没有面包屑。
hint-last-crumb = 这是最后一块面包屑：你的路标到此为止。
hint-too-many-crumb = 这个世界里的面包屑太多了；先收起一个。
hint-moved-crumb = 你收起了最早的面包屑，放到这里：一个世界最多有 512 个。
hint-none-there-log = 准星下没有原木。
hint-none-there-stone = 准星下没有石头。
hint-too-many-log = 这个世界里的原木太多了，请先收起一根。
hint-too-many-stone = 这个世界里的石头太多了，请先收起一块。
hint-too-many-seed = 这里不能再种树了。
hint-no-place-for-door = 八米之内没有可以立门的地面。
hint-door-steep = 这里的地面太陡，立不了门：请找一块平地，或者挖出、筑出一块。
hint-door-walled = 这里有岩石挡着：门前门后各需要一米空间。
hint-door-crowded = 另一扇门太近：请在两扇门之间留出两米半。
against-door-steep = 太陡，立不了门
against-door-walled = 有岩石挡着
against-door-crowded = 离另一扇门太近
hint-none-there-door = 准星下没有门。
hint-too-many-door = 这个世界里已经有一对门了，请先收起一扇。
hint-moved-door = 较早的那扇门现在在这里。
hint-no-room = 你拿不下更多东西了。
hint-too-many-drops = 地上的东西太多了，请先捡起一些。
hint-died-of-fall = 你摔得太重了。你会在起点重新站起来。
hint-died-of-shot = 你被击中了。你会在起点重新站起来。
hint-died-of-crash = 你在撞车中丧生。你会在起点重新站起来。
hint-died-of-car = 你被车撞死了。你会在起点重新站起来。
hint-died-of-tree = 一棵树砸中了你。你会在起点重新站起来。
hint-no-car-near = 四米之内看不到车。
hint-look-at-car = 车就在你旁边。看着它才能上车。
hint-car-too-far = 车太远了，上不去。请靠近一些。
hint-at-the-wheel = 你正在驾驶。刹车：{ $brake } · 镜头：{ $camera } · 喇叭：{ $horn } · 下车：{ $leave }
hint-fallen-over = 车翻了。{ $flip } 将它扶正。
hint-no-way-out = 车旁没有可以下车的空地。
hint-back-again = 你回到了起点，带着的东西都还在。
hint-been-round = 你绕了世界一整圈，{ $metres } 米，又回到了原来的地方。
hint-nobody-to-talk-to = 前面没有可以交谈的人。
hint-too-far-to-talk = 他们离得太远，无法交谈。请走近些。
hint-waits-to-talk = 他们听见了，正在等你。请走近些交谈。
hint-in-the-way = 你站在顶壁之下，挡住了要建造的地方。请后退，或换用更小的笔刷。
hint-out-of-reach = 够得着的地方没有可挖的。请走近些。
hint-too-hard = 这把镐挖不动：{ $kind }。可以用挖到的东西做一把更好的。
hint-nothing-to-build = 没有可以用来建造的土。请先挖一些。
hint-used-up = 没有了：{ $kind }。请选择别的土，或者再挖一些。
hint-made = 已制作：{ $item }
hint-no-coal-yet = 你挖得很深，却没有找到煤。煤层大约在一半的土地下面：换到三十米外再挖，或者看看洞穴的岩壁。
hint-undone = 已撤销最后一笔。
hint-undo-none-left = 没有可以撤销的笔了。
hint-undo-away = 最后一笔太远，无法撤销。请回到画它的地方。
hint-undo-changed = 最后一笔保留：那里的地面之后又改变了。
hint-undo-spent = 最后一笔保留：它带来的土已经用掉了。
hint-undo-unreadable = 最后一笔保留：现在无法读取那里保存的地面。请确认磁盘可用，然后重试。

talk-triangle-flat = 我放了三盏灯，每盏离另外两盏都是 { $side } 米。从一盏看另外两盏，三个角加起来是 { $sum }°，和学校里教的一样。
talk-triangle-pictured = 我放了三盏灯，每盏离另外两盏都是 { $side } 米。从一盏看另外两盏，三个角加起来是 { $sum }°：大地是平的，弯曲的只是画面。
talk-hello = 你好！{ $words }
talk-triangle-more = 我放了三盏灯，每盏离另外两盏都是 { $side } 米。从一盏看另外两盏，三个角加起来是 { $sum }°，超过了 180°。
talk-triangle-less = 我放了三盏灯，每盏离另外两盏 { $side } 米。从每一盏看另外两盏，三个角加起来是 { $sum }°，不到 180。
talk-horizon-lower = 看到 { $away } 米外和这里一样高的地面了吗？它看起来比平直画面中低 { $angle }°。
talk-horizon-flat = 看到 { $away } 米外和这里一样高的地面了吗？它正好在平直画面中的位置。
talk-horizon-higher = 看到 { $away } 米外和这里一样高的地面了吗？它看起来比平直画面中高 { $angle }°。
talk-home-round = 从这里回家是 { $there } 米，往另一边绕世界一圈是 { $round } 米。
talk-home-straight = 从这里回家是 { $there } 米。大地没有尽头，所以没有路能绕回去。
talk-home-squares = 家离这里 { $there } 米，{ $squares ->
    [0] 就在这个方块里
   *[other] 隔着 { $squares } 个方块
}。别的路都更长，多半长得多。
talk-land = 在这个高度，方圆 { $within } 米内的土地是平地上的 { $times } 倍。越低处越多。
talk-square = 走 { $side } 米，右转，这样做四次。在平地上你会回到原处；在这里，你离出发的地方还有 { $gap } 米。

open-failed = 无法打开世界
open-died = 读取时出了错；详情见日志。
save-failed = 无法保存世界
close-died = 写入世界时出了错；详情见日志。
not-saved = 世界最后的改动没有保存。
not-saved-yet = 无法保存世界；下次保存会再试。
save-unfinished = 最后一次地形改动或其保存没有及时完成；之前保存的一切都安全。

save-in-use = 世界“{ $world }”正在使用：它在游戏的另一个窗口或另一个程序中打开着。请在那里关闭它，然后重试。
save-newer = 世界“{ $world }”由更新版本的游戏保存。请更新游戏后再玩；没有改动任何东西。
save-damaged = 这个世界的一部分已损坏。其余部分可以使用；如果有较早的副本，“antipode saves repair”会恢复它。（{ $details }）
save-part-damaged = 这个世界有一部分已损坏。其余可以使用；“antipode saves verify”会指出是哪里，“antipode saves repair”会在有旧副本时恢复它。
save-unreadable = 存档 { $path } 已损坏，无法读取。“antipode saves repair”会抢救完好的部分，并保留这个文件。
save-file-missing = 这个世界的文件 { $path } 不见了。如果你有副本，请放回原处；否则“antipode saves repair”会尽可能重建世界。
save-vanished = 存档 { $path } 不见了：世界打开时它的文件夹被移动、删除或替换，因此无法在那里保存。请把文件夹放回原处，然后再保存。
save-not-found = 世界“{ $world }”已不存在。
saves-busy = 另一个游戏正在 { $path } 中创建、重命名或导入世界，一直没有完成。请稍后重试，或关闭另一个游戏。
saves-not-a-folder = { $path } 是一个文件，里面不会有世界。请用 --saves-dir 选择一个文件夹。
file-exists = { $path } 已经存在，不会被覆盖。请另选名称或把它移开。
disk-full = 磁盘空间不足，无法写入 { $path }。请腾出一些空间后再保存；之前保存的都安全。
not-writable = 无法写入 { $path }：它是只读的，或属于别人。请更改权限，或用 --saves-dir 选择别的位置。
not-readable = 无法读取 { $path }：权限不允许，或属于他人。请更改权限，或用 --saves-dir 另选位置。
archive-refused = 无法导入 { $path }：它不是导出的世界，或已损坏。详情见日志。
unknown-space = 世界“{ $world }”所在的空间是这个版本不认识的。更新版本的游戏也许能打开它。
unknown-generator = 世界“{ $world }”的地形是用这个版本不认识的方式生成的。更新版本的游戏也许能打开它。
impossible-radius = 世界“{ $world }”称其空间的半径为 { $radius } 米，而任何世界都不可能如此。它的文件保持原样。
player-damaged = 存档中的玩家数据已损坏；你从起点重新开始。你的大地保持原样。
unknown-item = 存档中有这个版本不认识的物品（“{ $item }”）；它不会显示，但仍保留在存档中。
unknown-records = 存档中有 { $count } 个来自更新版本的东西；它们不会显示，但仍保留在存档中。
unknown-map = 存档中有这个版本不认识的图（“{ $map }”）；改为显示另一种。
more-damaged = 这个世界还有 { $count } 处损坏；“antipode saves verify”会列出它们。
land-trouble = 大地出了问题。{ $details }
other-trouble = 没有成功。{ $details }

name-empty = 请给世界起个名字。
name-blank = 名称至少要有一个可见的字符。
name-too-long = 名称有 { $chars } 个字符；最多 { $most } 个。
name-unprintable = 名称中有无法显示的字符（{ $code }）。
name-taken = 已经有一个叫“{ $name }”的世界。
room-name-taken = 已经有一个名为“{ $name }”的房间。

no-adapter = 这台电脑上没有找到游戏可用的显卡（{ $found }）。请安装显卡驱动，或用 --adapter software 启动游戏。
adapter-lost = 显卡连接已丢失。你的世界是安全的；请重新启动游戏。
adapter-refuses = 显卡拒绝了游戏的一个着色器（{ $details }）。请更新显卡驱动，或用 --adapter software 启动游戏。
adapter-reopened = 显卡连接曾丢失，现已重新打开。

# Why the game was started anew after its graphics had failed for good, and what draws now.
graphics-title = 图形出现故障
graphics-lost = 显卡连接已丢失，且无法重新打开。你的世界已保存。
graphics-software = 游戏已重新启动，现在由处理器绘制，速度较慢。想再次尝试显卡，请退出后重新启动游戏。

# 上一次运行时的崩溃。
crash-title = 游戏崩溃了
crash = 游戏意外停止，已重新启动。你的世界和房间保持上次保存时的样子，最多相差几秒。关于这次崩溃的信息在 { $report }。

# 生物群系：进入时只显示名称。
biome-volcanic = 火山地带
biome-desert = 沙漠
biome-forest = 森林
biome-toxic = 毒原
biome-jungle = 丛林
biome-tundra = 苔原
biome-wetland = 湿地
biome-crags = 峭壁
biome-shore = 海岸
biome-cave = 洞穴
