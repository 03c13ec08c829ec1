### 世界上方的显示。

display-chart = 图卡
display-curved = 模型
display-flat = 平直空间：相同
display-loading = 大地正在出现：{ $percent }%
display-hemisphere = 半球 { $letter }
display-brush = 笔刷 { $radius } 米
display-speed = { $speed } 公里/时

compass-north = 北
compass-east = 东
compass-south = 南
compass-west = 西
compass-equator = { $letter } · 赤道 { $metres } 米
compass-home = 回家 { $metres } 米 · { $squares ->
    [0] 就在这个方块
   *[other] { $squares } 个方块
}
compass-flag = { $name } · { $metres } 米
compass-way-back = 回头路
display-sighting = 三面旗：{ $here }° + { $seen }° + { $third }° = { $sum }° · 边长 { $a }、{ $b }、{ $c } 米

dial-raised = 曲率，抬升
dial-horizon = 曲率，地平
dial-bend-hyperbolic = 弯曲，双曲
dial-bend-spherical = 弯曲，球面
dial-bend-flat = 弯曲，平直

space-hyperbolic = 双曲透镜
space-hyperbolic-world = 双曲世界
space-euclidean = 欧几里得
space-spherical = 球面

item-pickaxe-wood = 木镐
item-pickaxe-iron = 铁镐
item-pickaxe-diamond = 钻石镐
item-gun = 枪
item-bullet = 子弹
item-lamp = 灯
item-flag = 旗子
item-door = 门
item-log = 原木
item-stone = 石头
item-seed = 种子
item-crumb = 面包屑
flag-unnamed = 旗子 { $number }
flag-name-title = 这面旗子叫什么名字？
flag-name = 旗子的名字
flag-name-keep = 保持原样

figures-fps = { $frames } 帧/秒
figures-fps-unknown = 帧/秒未知
figures-ms = { $ms } 毫秒
figures-unknown = 未知
figures-times = { $fps }   每帧 { $frame }   GPU { $gpu }   { $time }
figures-comma = { "，" }
figures-chunks = 区块
figures-chunks-are = { $frame } 整块，{ $vertex } 逐顶点，{ $refined } 加密
figures-detail = 细节
figures-detail-is = { $full } 全，{ $half } 二分之一，{ $quarter } 四分之一，{ $eighth } 八分之一
figures-drawn = 绘制
figures-drawn-are = { $triangles } 个三角形
figures-saved = 省去
figures-saved-are = { $outside } 画面外，{ $hidden } 被遮挡，{ $small } 太小
figures-error = 误差
figures-error-is = 最多 { $most } 像素，远处大地 { $far } 像素
figures-dropped = 丢弃
figures-dropped-is = { $seconds } 秒时间
picture-raised = 抬升图 { $value }
picture-horizon = 地平图 { $value }
picture-bend = 弯曲 { $sign }{ $value }
quality-fast = 快速
quality-balanced = 均衡
quality-exact = 精确

# In rooms: how far off what is under the crosshair is, and how large one is.
room-ahead = { $felt } 米
room-ahead-bent = 走过去 { $felt } 米，从外面看 { $scene } 米
room-smaller = 你在这里比在外面小 { $times } 倍
room-larger = 你在这里比在外面大 { $times } 倍
room-smaller-level = 沿着地面，你在这里比在外面小 { $times } 倍
room-larger-level = 沿着地面，你在这里比在外面大 { $times } 倍
room-smaller-up = 在高度上，你在这里比在外面小 { $times } 倍
room-larger-up = 在高度上，你在这里比在外面大 { $times } 倍
room-smaller-began = 你比开始时小 { $times } 倍
room-larger-began = 你比开始时大 { $times } 倍
room-keys = { $look }：精确的画面或论文的画面 · { $camera }：从背后看 · { $gun }：射击 · { $lamp }：放下或拾起灯 · { $lift }：举起或放下松动的东西 · { $ball }：扔球 · { $anew }：重新开始 · { $again }：再看一次 · { $edges }：盒子的边线
room-keys-own = { $build }：在这里建造
# The ways to look at a room, and what differs in the middle of the picture.
room-look-split = 左边按论文的规则（这类房间的最初尝试），右边是精确的
room-look-thesis = 按论文的规则，即这类房间的最初尝试
room-look-plain = 如平面图：没有任何拉伸或弯曲
room-half-thesis = 论文
room-half-exact = 精确
room-differs = 画面中央：{ $exact }；按论文：{ $thesis }。
room-differs-bent = 画面中央：{ $exact }；按论文：{ $thesis }，光线到达那里时弯曲了 { $bent }°。
room-sky = 天空
room-own = 这个房间是你的。
display-brush-shape = { $shape } { $radius } 米
display-heap = { $sign }{ $volume } 立方米 { $kind }
display-ground-left = { $kind }，还剩 { $volume } 立方米
ground-none = 还没有
ground-found = 原有的
ground-grass = 草
ground-soil = 泥土
ground-sand = 沙
ground-gravel = 碎石
ground-rock = 岩石
ground-ash = 火山灰
ground-snow = 雪
ground-moss = 苔
ground-clay = 黏土
ground-basalt = 玄武岩
ground-slate = 板岩
ground-coal = 煤
ground-copper = 铜
ground-crystal = 水晶
ground-wood = 木头
brush-ball = 球
brush-box = 方块
brush-cylinder = 圆柱
brush-flatten = 铲平
brush-smooth = 平滑
