### 工坊：在其中建造房间。

# 可以建造的房间。
workshop-rooms-none = 你还没有自己的房间。新建一个，或在游戏自带房间的页面（三个点）上复制一个。第一个房间附带教程。
workshop-rooms-shipped = 游戏自带的房间
workshop-rooms-load = 建造
workshop-rooms-load-named = 在“{ $name }”中建造
workshop-not-own = 这个房间是游戏自带的。请复制它，然后在副本中建造。
workshop-not-kept = 房间无法保存：{ $reason }
workshop-not-saved-yet = 你的修改都已保留，但在解决这个问题之前，房间的文件保持原样：{ $reason }
workshop-kept = 房间正在保存。它也会自动保存：每一步都在两秒之内。

# 面板。
workshop-pane-view = 视图
workshop-pane-list = 物体
workshop-pane-inspector = 属性
workshop-pane-parts = 部件
workshop-pane-messages = 消息
workshop-pane-history = 历史
workshop-search = 搜索
workshop-none-found = 没有这样的名称。
workshop-rename = 新名称
workshop-hide = 隐藏“{ $name }”
workshop-fold = 折叠“{ $name }”
workshop-lock = 锁定“{ $name }”
workshop-reset = 重置{ $name }
workshop-parts-hint = 点击即可把部件放在你所看之处。
workshop-all-well = 这个房间没有问题。
workshop-note-ahead = 上次游戏结束时，这个房间最后的编辑还没有写入文件。它们已经恢复，无需处理。
workshop-note-changed = 自从上次在这里保存后，别的程序改动了这个房间的文件。那是历史中的最后一步；撤销它就能恢复原样。
workshop-note-aside = 这个房间的日志已损坏，被移到 { $file }。较早的步骤可能缺失；历史中的“旧版本”会显示还保留着什么。
workshop-in-use = 游戏的另一个窗口正在建造这个房间。在这里你可以走动；要在这里建造，请先在那边关闭它。
workshop-no-journal = 这个房间的文件夹无法写入（{ $reason }）。你可以走动；要建造，请让文件夹可写，然后重新进入。
workshop-drop-elsewhere = 建造房间时可以把文件拖进来：主菜单中的工坊，或在自己的房间里按 F5。
workshop-drop-choose = 先选择要贴上图片的物体，再把图片拿来。
workshop-older = 旧版本
workshop-older-about = 点击后用该版本替换房间。这是一步操作，可以撤销。
workshop-older-none = 还没有旧版本。编辑半分钟后会保存一个。
workshop-beginning = 开始
workshop-room-itself = 房间本身
workshop-one = { $name }（{ $kind }）
workshop-several = { $count } 个物体
workshop-status-nothing = 点击物体；或按住右键并用 W A S D、E、Q 飞行。
workshop-status-chosen = 拖动物体或手柄 · 方向键：一步 · F：对准 · Alt：不吸附
workshop-status-turn = 拖动圆环：每步 15° · F：对准 · Alt：不吸附
workshop-status-scale = 拖动手柄：另一侧不动 · F：对准 · Alt：不吸附
workshop-status-scale-whole = 拖动手柄：整体放大 · F：对准
workshop-status-flies = W A S D、E 和 Q 飞行，方向键转动。V 或 Esc 结束。
workshop-status-late = 正在重新绘制…
workshop-outside-inside = 外 { $outside } 米，内 { $inside } 米

# 操作。
workshop-do-play = 游玩
workshop-do-leave = 离开房间
workshop-do-undo = 撤销
workshop-do-redo = 重做
workshop-do-move = 移动
workshop-do-turn = 旋转
workshop-do-scale = 缩放
workshop-do-own-axes = 自身轴
workshop-do-snaps = 吸附
workshop-do-on-surfaces = 贴面
workshop-do-copy = 复制
workshop-do-cut = 剪切
workshop-do-paste = 粘贴
workshop-do-duplicate = 重复
workshop-do-array = 排成一行
workshop-do-group = 编组
workshop-do-ungroup = 取消编组
workshop-do-delete = 删除
workshop-do-choose-all = 全选
workshop-do-focus = 对准所选
workshop-do-top = 俯视
workshop-do-front = 正视
workshop-do-side = 侧视
workshop-do-start = 从起点看
workshop-do-flies = 按键飞行
workshop-do-raster = 先用快速画面
workshop-grid = { $metres } 米
workshop-menu-edit = 编辑
workshop-menu-room = 房间
workshop-menu-view = 视图
workshop-key-ctrl = Ctrl
workshop-key-shift = Shift

# 单位。
workshop-unit-metres = { $value } 米
workshop-unit-degrees = { $value }°
workshop-unit-times = × { $value }
workshop-unit-plain = { $value }

# 物体种类。
workshop-kind-box = 方块
workshop-kind-pyramid = 棱锥
workshop-kind-ramp = 斜坡
workshop-kind-cylinder = 圆柱
workshop-kind-ball = 球
workshop-kind-stairs = 楼梯
workshop-kind-arch = 拱门
workshop-kind-model = 模型
workshop-kind-light = 灯
workshop-kind-aberration = 空间
workshop-kind-portal = 传送门
workshop-kind-sign = 牌子
workshop-kind-group = 组

# 部件。
workshop-part-box = 方块
workshop-about-box = 一米见方的块。
workshop-part-wall = 墙
workshop-about-wall = 宽 4 米，高 2.5 米。
workshop-part-floor = 地板
workshop-about-floor = 4 乘 4 米的板。
workshop-part-pyramid = 棱锥
workshop-about-pyramid = 尖端朝上。
workshop-part-ramp = 斜坡
workshop-about-ramp = 向前方升高。
workshop-part-stairs = 楼梯
workshop-about-stairs = 八级，升高 2 米。
workshop-part-arch = 拱门
workshop-about-arch = 开有门洞的块。
workshop-part-cylinder = 圆柱
workshop-about-cylinder = 直立，高 2 米。
workshop-part-ball = 球
workshop-about-ball = 直径一米的球。
workshop-part-light = 灯
workshop-about-light = 点光源；每个房间最多八盏。
workshop-part-sign = 牌子
workshop-about-sign = 可以阅读的牌子。
workshop-part-tunnel = 隧道
workshop-about-tunnel = 外 4 米，内 20 米，自带墙壁。里面没有弯曲。
workshop-part-hall = 更大的空间
workshop-about-hall = 敞开的盒子，内部大一倍。进入者会缩小一半。可以在周围加墙壁，或用房子。
workshop-part-portals = 一对传送门
workshop-about-portals = 走进一个，从另一个走出。

# 属性。
workshop-field-name = 名称
workshop-field-at = 位置
workshop-field-at-group = 在组中的位置
workshop-field-turn = 转向（绕 y、z、x）
workshop-field-size = 尺寸
workshop-field-radius = 半径
workshop-field-height = 高度
workshop-field-steps = 级数
workshop-field-opening = 门洞
workshop-field-scale = 比例
workshop-field-text = 文字
workshop-field-colour = 颜色
workshop-field-power = 亮度
workshop-field-checker = 棋盘格
workshop-field-checker-colour = 第二种颜色
workshop-field-checker-size = 方格边长
workshop-field-texture-file = 图片
workshop-texture-none = 可以贴上图片：Ctrl+O。
workshop-field-texture-size = 图片边长
workshop-field-finish = 表面
workshop-field-glow = 自发光
workshop-field-box = 外部尺寸
workshop-field-lengths = 拉伸方式
workshop-field-axis = 轴
workshop-field-felt = 内部长度
workshop-field-times = 拉伸
workshop-field-times-x = 沿 x 拉伸
workshop-field-times-y = 沿 y 拉伸
workshop-field-times-z = 沿 z 拉伸
workshop-field-thesis = 论文中的 d
workshop-field-sides = 侧面
workshop-field-ways = 对谁有效
workshop-field-outline = 显示边线
workshop-field-to = 通向
workshop-field-sentence = 奇特之处
workshop-field-spawn-at = 起点
workshop-field-spawn-look = 起点视线（偏航，俯仰）
workshop-field-gravity = 重力
workshop-field-sky = 天空
workshop-field-light = 环境光
workshop-field-has-sun = 太阳
workshop-field-sun = 太阳方位
workshop-field-sun-colour = 太阳颜色
workshop-field-sun-power = 太阳亮度
workshop-field-has-fog = 雾
workshop-field-fog = 能见距离
workshop-field-fog-colour = 雾的颜色
workshop-choice-finish-matt = 哑光
workshop-choice-finish-mirror = 镜面
workshop-choice-finish-glass = 玻璃
workshop-choice-lengths-felt = 一条轴
workshop-choice-lengths-stretch = 所有轴
workshop-choice-axis-x = x（红）
workshop-choice-axis-y = y（绿）
workshop-choice-axis-z = z（蓝）
workshop-choice-sides-walls = 墙壁
workshop-choice-sides-soft = 敞开
workshop-choice-sides-snell = 折射
workshop-choice-sides-legacy = 论文的规则
workshop-choice-sides-1 = 单面
workshop-choice-sides-2 = 双面
workshop-choice-ways-both = 所有进入的人
workshop-choice-ways-forward = 只有沿轴前进的人

# 空间的作用。
workshop-told-felt = 外部长 { $outside } 米，内部感觉长 { $inside } 米：步行 { $seconds } 秒，而不是 { $before } 秒。
workshop-told-smaller = 进入者缩小 { $times } 倍，因此里面的一切大同样倍数。视线不会因此弯曲。
workshop-told-larger = 进入者放大 { $times } 倍，因此里面的一切小同样倍数。视线不会因此弯曲。
workshop-told-walls = 自带墙壁；没有弯曲，门内外一样大。
workshop-told-soft = 穿过每个面时方向不变：看到哪里就走到哪里。
workshop-told-snell = 光像在玻璃中一样折射，超过某角度则反射。
workshop-told-legacy = 论文的规则有缺陷：所见取决于看的方向，也走不到所见之处。
workshop-told-no-door = 拉伸多于一条轴时墙上没有门。只拉伸一条轴，或把侧面改为敞开。
workshop-told-astigmatic = 透过它看，直线是弯的，因为各侧面拉伸不均。
workshop-told-grazing = 沿侧面看去，一切显得被压扁。
workshop-told-itself = 它通向自己：照见观看者。
workshop-told-alike = 与“{ $name }”一样大：通过者大小不变。
workshop-told-grows = 前往“{ $name }”者变大 { $times } 倍。
workshop-told-shrinks = 前往“{ $name }”者缩小 { $times } 倍。

# 历史步骤。
workshop-step-add = 添加“{ $name }”等 { $count } 个
workshop-step-remove = 删除“{ $name }”等 { $count } 个
workshop-step-move = 移动“{ $name }”等 { $count } 个
workshop-step-turn = 旋转“{ $name }”等 { $count } 个
workshop-step-pose = 摆放“{ $name }”等 { $count } 个
workshop-step-resize = 改变“{ $name }”等 { $count } 个的尺寸
workshop-step-stretch = 拉伸“{ $name }”等 { $count } 个
workshop-step-sides = “{ $name }”等 { $count } 个的侧面
workshop-step-surface = “{ $name }”等 { $count } 个的表面
workshop-step-link = 连接“{ $name }”等 { $count } 个
workshop-step-text = “{ $name }”等 { $count } 个的文字
workshop-step-light = “{ $name }”等 { $count } 个的光
workshop-step-change = 更改“{ $name }”等 { $count } 个
workshop-step-rename = 将“{ $name }”改名为“{ $new }”
workshop-step-group = 编组“{ $name }”
workshop-step-carry = 将“{ $name }”等 { $count } 个移出组
workshop-step-ungroup = 取消编组“{ $name }”等 { $count } 个
workshop-step-duplicate = 重复“{ $name }”等 { $count } 个
workshop-step-array = 排列“{ $name }”等 { $count } 个
workshop-step-paste = 粘贴“{ $name }”等 { $count } 个
workshop-step-room = 房间本身
workshop-step-spawn = 起点
workshop-step-several = 多项更改
workshop-step-outside = 在游戏外更改
workshop-step-version = 版本 { $when }

# 可能的问题。
workshop-finding-not-parallel = “{ $name }”部分位于“{ $other }”之中且转向不同；在两者的轴平行或一个完全位于另一个之内以前，它是关闭的。
workshop-finding-too-deep = “{ $name }”嵌套的拉伸空间过多（其中有“{ $other }”），最多八层。
workshop-finding-walls-across = “{ $name }”的一面墙横在“{ $other }”里，那里无法通过；请把其中一个移开。
workshop-finding-same-place = “{ $name }”与“{ $other }”在同一位置；请移动或删除它。
workshop-finding-tangled = “{ $name }”与太多其他物体重叠，无法判断深度；请移开一些。
workshop-finding-no-door = “{ $name }”六面都是墙，没人能进去。
workshop-finding-out-of-range = “{ $name }”有超出范围的数值。
workshop-finding-no-partner = 传送门“{ $name }”无处可去：没有它所通向的传送门。
workshop-finding-one-way = 传送门“{ $name }”通向“{ $other }”，但后者不通回。
workshop-finding-other-sides = “{ $name }”与“{ $other }”的面数不同。
workshop-finding-not-similar = “{ $name }”与另一端“{ $other }”不相似：请让两者尺寸成比例。
workshop-finding-other-size = “{ $name }”与“{ $other }”的尺寸相差超过 32 倍。
workshop-finding-portal-shape = “{ $name }”的角不构成凸形。
workshop-finding-over-side = 传送门“{ $name }”横跨“{ $other }”的侧面；请完全放入或移出。
workshop-finding-in-odd-box = 传送门“{ $name }”位于“{ $other }”中，那里不能放传送门。
workshop-finding-portals-touch = 传送门“{ $name }”与“{ $other }”相接；请至少分开一毫米。
workshop-finding-spawn-in-solid = 起点在“{ $name }”内部。
workshop-finding-spawn-in-air = { $metres ->
    [0] 起点下方空无一物，会掉出房间。
   *[other] 起点在空中，会下落 { $metres } 米。
}
workshop-finding-open-sides = “{ $name }”的侧面敞开：光线会在那里弯曲。请遮住它们或加上墙壁。
workshop-finding-fall-out = 步行 { $metres } 米后可能掉出房间。
workshop-finding-unreached = 从起点步行到不了“{ $name }”。

# Help, and parts of several things.
workshop-reset-short = 重置
workshop-menu-help = 帮助
workshop-do-lesson = 课程：内部更大的房子
workshop-do-examples = 能做什么
workshop-do-parallel = 无透视
workshop-do-walls = 隐藏隧道的墙壁
workshop-field-times-all = 所有轴的拉伸
workshop-field-group = 所属组
workshop-choice-group-none = 无
workshop-part-house = 内部更大的房子
workshop-about-house = 4 米的房子，有门。内部大一倍，进入者会缩小一半。

# The lesson.
workshop-lesson-title = 课程：第 { $number } 步，共 { $of } 步
workshop-lesson-put = 在部件中点击“内部更大的房子”：它就会出现在你面前。
workshop-lesson-move = 用左键把房子拖开一点。
workshop-lesson-choose = 在物体列表中点击“{ $name }”：那是房子里的空间。
workshop-lesson-stretch = 把“所有轴的拉伸”向右拖：房子内部变大，外面不变。
workshop-lesson-enter = 按“游玩”（F5），从门走进去。
workshop-lesson-walk = 从门走进房子。按 F5 回到工坊。
workshop-lesson-walk-tunnel = 走过隧道，数一数步数。按 F5 回到工坊。
workshop-lesson-done = 你建成了内部更大的房子。回到工坊（F5），帮助里有第二课（隧道和传送门），还有更多能做的。
workshop-lesson-skip = 跳过这一步
workshop-lesson-end = 结束课程

# What is possible.
workshop-examples-title = 能做什么
workshop-examples-about = 每一个都可以复制到你的房间，再在那里更改。
workshop-examples-copy = 复制到房间
workshop-examples-copy-named = 把“{ $name }”复制到房间
workshop-examples-close = 关闭
workshop-example-tunnel-longer = 内部更长的隧道
workshop-example-tunnel-longer-about = 旁边走 4 米，里面走 20 米。
workshop-example-tunnel-shorter = 内部更短的隧道
workshop-example-tunnel-shorter-about = 旁边走 16 米，里面走 2 米。
workshop-example-house = 内部更大的房子
workshop-example-house-about = 外面 4 米，里面 8 米。
workshop-example-portals = 一对传送门
workshop-example-portals-about = 走进一个，从另一个走出。
workshop-example-portals-of-size = 大小不同的传送门
workshop-example-portals-of-size-about = 从大门走出的人大三倍。
workshop-example-falling-loop = 无尽的坠落
workshop-example-falling-loop-about = 从下面落入，从上面出来。

# Partners of portals.
workshop-link-to = 拖到另一个传送门上。
workshop-link-partner = 通向“{ $name }”：拖到另一个
workshop-told-no-partner = 它无处可去，处于关闭状态：请选择它通向的传送门。
workshop-told-one-way = 处于关闭状态：“{ $name }”不通回。
workshop-told-other-sides = 处于关闭状态：“{ $name }”的面数不同。
workshop-told-not-similar = 处于关闭状态：“{ $name }”形状不同。请让两者的宽高比相同。
workshop-told-ill-placed = 处于关闭状态：它或“{ $name }”所在之处不能有传送门。消息会说明原因。

# Files from the disk.
workshop-do-from-file = 从文件中取模型或图片
workshop-do-keep = 立即保存
workshop-chooser-title = 模型或图片
workshop-chooser-about = 模型（glb、gltf、fbx、obj）会出现在你面前；图片（png、jpg）会贴在所选的物体上。
workshop-chooser-path = 路径
workshop-chooser-open = 打开
workshop-chooser-up = 上一层文件夹
workshop-chooser-home = 我的文件夹
workshop-chooser-close = 取消
workshop-chooser-reading = 正在读取文件夹。
workshop-chooser-empty = 这里没有文件夹、模型或图片。
workshop-chooser-folder = 文件夹
workshop-chooser-unread = 无法读取 { $path }（{ $reason }）。请输入另一条路径，或从下面的文件夹继续。
workshop-chooser-unfit = { $path } 不是模型（glb、gltf、fbx、obj），也不是图片（png、jpg）。请存为其中一种，或选择另一个文件。
workshop-chooser-many = 显示 { $count } 个中的前 { $shown } 个；其他的请输入路径。

# What fields do, where the pointer rests.
workshop-hover-sides = 不该有人穿过的侧面上有什么：墙、什么也没有、或像玻璃的东西。
workshop-hover-ways = 从另一端来的人，可以感到空间和看上去一样长。
workshop-hover-outline = 盒子的边线在游戏中也看得到，不只在这里。
workshop-hover-lengths = 一条轴让隧道变长或变短；所有轴让房间内部变大或变小。
workshop-hover-thesis = 一篇论文（最早做出这种房间的程序）计算拉伸的方式，方向相反：里面的一米在外面占 1 + d 米。0 没有变化，2 使里面缩为三分之一，−0.8 使里面长五倍。

# The second lesson, and a portal alone.
workshop-do-lesson-doors = 课程：隧道和传送门
workshop-part-portal = 传送门
workshop-about-portal = 在把线拖到另一个传送门之前，它通向自己。
workshop-lesson-tunnel = 在部件中点击“隧道”：它就会出现在你面前。
workshop-lesson-longer = 选中“{ $name }”后，把“拉伸”向右拖：内部变长，外面不变。
workshop-lesson-portal = 在部件中点击“传送门”：这是两个中的第一个。
workshop-lesson-portal-again = 再点击一次“传送门”：第二个会在第一个旁边。
workshop-lesson-link = 从“{ $name }”上方的圆点拖到“{ $other }”的中间：它们就通向对方。
workshop-lesson-through = 按“游玩”（F5），走过隧道。
workshop-lesson-pass = 按“游玩”（F5），走进一个传送门：你会从另一个出来。
workshop-lesson-walk-doors = 隧道走完了。现在走进一个传送门。按 F5 回到工坊。
workshop-lesson-done-doors = 你建成了内部更长的隧道，还有通向对方的两个传送门。回到工坊（F5），帮助里有更多能做的。
workshop-link-itself = 通向自己：拖到另一个传送门
workshop-link-nowhere = 哪里也不通：拖到一个传送门
workshop-hover-own-axes = 手柄按物体自己的轴，而不按房间的轴。
workshop-hover-snaps = 移动按网格步进，旋转按 15° 步进。按住 Alt 可暂时取消。
workshop-hover-on-surfaces = 拖动的物体贴在指针下的表面上：地面、墙壁、屋顶。

# What parts and their things are called in a room.
workshop-name-bottom = 下面
workshop-name-top = 上面
workshop-name-falling-loop = 坠落环
workshop-name-falling-loop-lintel = 坠落环横梁
workshop-name-falling-loop-pillar = 坠落环立柱
workshop-name-falling-loop-rim = 坠落环边
workshop-name-house = 房子
workshop-name-house-back = 房子后墙
workshop-name-house-ceiling = 房子天花板
workshop-name-house-floor = 房子地板
workshop-name-house-front = 房子前墙
workshop-name-house-inside = 房子内部
workshop-name-house-lamp = 房子灯
workshop-name-house-left = 房子左墙
workshop-name-house-light = 房子灯光
workshop-name-house-lining-back = 房子后衬
workshop-name-house-lining-front = 房子前衬
workshop-name-house-lining-left = 房子左衬
workshop-name-house-lining-right = 房子右衬
workshop-name-house-right = 房子右墙
workshop-name-house-roof = 房子屋顶
workshop-name-large-portal = 大传送门
workshop-name-large-portal-frame = 大传送门框
workshop-name-left-post = 左柱
workshop-name-lintel = 横梁
workshop-name-long-tunnel = 长隧道
workshop-name-long-tunnel-inside = 长隧道内部
workshop-name-long-tunnel-slab = 长隧道石板
workshop-name-portal = 传送门
workshop-name-portal-frame = 传送门框
workshop-name-right-post = 右柱
workshop-name-short-tunnel = 短隧道
workshop-name-short-tunnel-inside = 短隧道内部
workshop-name-short-tunnel-slab = 短隧道石板
workshop-name-small-portal = 小传送门
workshop-name-small-portal-frame = 小传送门框
workshop-name-tunnel = 隧道
workshop-name-hall = 空间
workshop-name-box = 方块
workshop-name-wall = 墙
workshop-name-floor = 地板
workshop-name-stairs = 楼梯
workshop-name-ramp = 斜坡
workshop-name-arch = 拱门
workshop-name-pyramid = 棱锥
workshop-name-cylinder = 圆柱
workshop-name-ball = 球
workshop-name-light = 灯
workshop-name-sign = 牌子
workshop-name-group = 组
workshop-name-model = 模型
workshop-told-carried = 其中的全部宽 { $x } 米，高 { $y } 米，深 { $z } 米。

# The form of how something is repeated in a row.
workshop-array-count = 数量
workshop-array-axis = 方向
workshop-array-gap = 间隔
workshop-array-turn = 每个转动
workshop-array-make = 创建
workshop-array-close = 关闭
