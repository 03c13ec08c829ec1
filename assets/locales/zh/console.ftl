### 控制台，以及用过作弊命令的世界的标记。

action-console = 控制台

console-entry = 命令
console-hint = 输入命令；Tab 补全，help 列出全部，Esc 关闭
console-no-command = 没有命令“{ $name }”。help 会列出所有命令。
console-refused = 无法执行：{ $details }。
console-settled = 你周围的地形已全部就绪。
console-unsettled = 还有 { $count } 块地形正在生成。
console-no-wait = 这里时间自行流逝；只有脚本会等待。
console-no-perf = 只有脚本会测量。游戏中请看帧数据。
console-marked = 这个世界从此带有标记：其中用过作弊命令。
console-saving = 正在保存世界。
console-not-kept = 这个世界没有名称，因此不会保存。
console-open-already = “{ $name }”已经打开。
console-no-worlds = 还没有保存的世界。
console-world = { $name }（{ $space }，种子 { $seed }）
console-shot-name = 图片会放入 { $dir }；请给出不带文件夹的名称。

cheats-used = 用过作弊

console-help = 命令：{ $commands }。help 命令名 可查看详情。
console-help-new = 创建并进入新世界；当前世界会先保存。
console-help-load = 进入已保存的世界；当前世界会先保存。
console-help-save = 立即保存这个世界。
console-help-delete = 永久删除一个已保存的世界。
console-help-list = 列出已保存的世界。
console-help-quit = 保存这个世界并结束游戏。
console-help-hold = 按住某个键或鼠标键若干秒。
console-help-down = 按下某个键，直到“up”才松开。
console-help-up = 松开某个键。
console-help-tap = 按一下某个键。
console-help-click = 点一下鼠标键。
console-help-press = 按下鼠标键，直到“release”才松开。
console-help-release = 松开鼠标键。
console-help-look = 像鼠标一样转动视角，以像素计，向右、向下为正。
console-help-aim = 指定视角，以度计：0 沿 x，90 沿 z；向上为正。
console-help-scroll = 转动滚轮若干格。
console-help-wait = 让时间流逝；仅用于脚本。
console-help-settle = 告知周围地形是否就绪；脚本会等待。
console-help-probe = 以一行 JSON 给出世界的状态。
console-help-shot = 把你看到的画面（不含控制台）存入截图文件夹。
console-help-set = 更改这个世界的设置，或设置界面中你自己的一项设置。time、health 和 fly on 会标记世界。
console-help-give = 给你物品。会标记世界。
console-help-teleport = 把你送到别处，以图上米数计。会标记世界。
console-help-spawn = 在世界里放一个人物、一辆车、一盏灯或一面旗子。
console-help-name-flag = 给离你最近的旗子取名。
console-help-perf = 测量帧；仅用于脚本。
console-help-room = 创建、进入、保存、删除或列出变形空间的房间；目前只能在脚本中使用。
console-help-add = 在打开的房间中放入东西。
console-help-change = 改变打开的房间中的东西。
console-help-remove = 从打开的房间中取走东西。
console-help-group = 在打开的房间中建立一个带着其成员的组。
console-help-undo = 撤销对打开的房间的最近更改。
console-help-redo = 重做被撤销的房间更改。
console-help-help = 介绍所有命令或某一个。
