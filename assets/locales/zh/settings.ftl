### The settings screen. Keys made at run time: setting-<id>.

menu-settings = 设置
settings-search = 搜索设置
settings-nothing-found = 没有设置提到“{ $words }”。
settings-reset = 还原
settings-reset-named = 还原“{ $name }”

settings-group-look = 鼠标与视角
settings-group-picture = 画面
settings-group-world = 空间
settings-group-comfort = 语言、阅读与舒适

# { $value } is a number.
unit-degrees = { $value }°
unit-degrees-per-pixel = 每像素 { $value }°
unit-chunks = { $value ->
    [0] 自动
   *[other] { $value } 个区块
}
unit-notch = 每格 { $value }
unit-times = { $value } ×

setting-mouse-sensitivity = 鼠标灵敏度
setting-mouse-sensitivity-about = 鼠标移动一个像素时视角转动多少。
setting-invert-look = 上下反转
setting-invert-look-about = 鼠标向前推时视线向下，如同驾驶飞机。
setting-field-of-view = 视野
setting-field-of-view-about = 画面上缘与下缘之间的角度。角度越大看到的越多，一切也越小。

setting-preset = 画面针对
setting-preset-about = 使用显卡时，地面在近处显示草、波纹、卵石和岩层，并逐像素照明。为处理器绘制时只有生物群系的颜色，速度更快。自动：取决于由什么绘制。
setting-preset-auto = 自动
setting-preset-card = 显卡
setting-preset-software = 处理器

setting-quality = 质量
setting-quality-about = 画面用多少精确度换取速度。
setting-quality-fast = 快速
setting-quality-balanced = 均衡
setting-quality-exact = 精确
setting-view-distance = 视距
setting-view-distance-about = 在你周围多远的范围内生成地形；一个区块为 32 米。选“自动”且使用显卡时超过 300 米。每增加一级都要占用内存和时间。
setting-render-scale = 世界的分辨率
setting-render-scale-about = 以窗口分辨率的多大比例绘制世界。文字始终清晰。自动：有显卡时为全部，没有时为一半。
setting-render-scale-auto = 自动
setting-render-scale-25 = 25 %
setting-render-scale-50 = 50 %
setting-render-scale-67 = 67 %
setting-render-scale-75 = 75 %
setting-render-scale-100 = 100 %
setting-msaa = 平滑边缘（MSAA）
setting-msaa-about = 在地形边缘对一个像素多次采样，使边缘没有锯齿。自动：有显卡时四次，没有时一次。
setting-msaa-auto = 自动
setting-msaa-off = 关
setting-msaa-4x = 4 次采样
setting-shadows = 阴影
setting-shadows-about = 太阳和月亮投下的阴影。“高”更精细、更柔和。自动：有显卡时为高，没有时为低。
setting-shadows-auto = 自动
setting-shadows-off = 关
setting-shadows-low = 低
setting-shadows-high = 高
setting-frame-cap = 帧数上限
setting-frame-cap-about = 每秒最多多少画面。少一些，电脑更凉更静。
setting-frame-cap-30 = 30
setting-frame-cap-60 = 60
setting-frame-cap-90 = 90
setting-frame-cap-120 = 120
setting-frame-cap-144 = 144
setting-frame-cap-240 = 240
setting-frame-cap-none = 无上限
setting-vsync = 等待屏幕（垂直同步）
setting-vsync-about = 画面只在屏幕两次刷新之间更换。不等待则来得更早，但可能撕裂。
setting-fullscreen = 全屏
setting-fullscreen-about = 游戏占满屏幕。

setting-curvature-step = 曲率步长
setting-curvature-step-about = 滚轮转动一格时曲率改变多少。
setting-hyperbolic-map = 双曲地图
setting-hyperbolic-map-about = 新的双曲世界以此地图开始；在这里更改时，你所在的世界也随之更改。每个世界记住自己的地图。
setting-hyperbolic-map-raised = 隆起
setting-hyperbolic-map-horizon = 地平线
setting-contour-bands = 等高线
setting-contour-bands-about = 地面上的淡线，每 8 米高度一条。它们显示空间如何弯曲。
setting-compass = 罗盘
setting-compass-about = 在上方显示北方；在球面世界中还显示所在半球和通往赤道的方向；在双曲世界中显示回家的路；以及你的旗子在哪里。
setting-minimap = 小地图
setting-minimap-about = 你周围地面的圆形地图：高度、灯、旗子，以及附近有谁。
setting-rear-mirror = 后视镜
setting-rear-mirror-about = 引擎盖视角上方的镜子。自动：使用显卡时开启，由处理器绘制时关闭。
setting-rear-mirror-auto = 自动
setting-rear-mirror-off = 关
setting-rear-mirror-on = 开
setting-straight-shots = 直线射击
setting-straight-shots-about = 子弹沿空间中最直的线飞行，而不是沿弧线落下。

setting-language = 语言
setting-language-about = 所有文字的语言。“系统”是你电脑所用的语言，只要游戏会说。
setting-language-system = 系统
setting-language-en = English
setting-language-pl = Polski
setting-language-de = Deutsch
setting-language-es = Español
setting-language-zh = 中文
setting-ui-scale = 文字与按钮的大小
setting-ui-scale-about = 菜单和显示画得多大。
setting-high-contrast = 高对比度
setting-high-contrast-about = 菜单和显示以黑底上的白色与黄色绘制，毫不透明。
setting-safe-marker = 色盲适用的圆环
setting-safe-marker-about = 挖掘或建造处的圆环为白色带黑边：以明暗而非颜色区分。
setting-reduced-motion = 减少动态
setting-reduced-motion-about = 曲率直接跳变而不滑动，菜单不渐变，头部不下沉，引擎盖视角不倾斜，菜单背后也没有世界飞过。
setting-head-dip = 落地时下沉
setting-head-dip-about = 跳跃或坠落着地时视线稍稍下沉。
setting-wind = 风
setting-wind-about = 树叶和草会随风摇摆。减少动态时静止。

# The file of the settings. { $file } is a path, { $reason } comes from the system, { $value } from the file.
settings-file-damaged = 设置文件已损坏。能读出的部分有效；损坏的文件保存为 { $file }。
settings-file-newer = 设置文件来自更新版本的游戏。其中认识的部分有效；它保存为 { $file }。
settings-file-older = 设置文件来自较旧版本，已经更新；旧文件保存为 { $file }。
settings-file-kept = 设置文件的一部分无法使用；原文件保存为 { $file }。
settings-file-value = 设置“{ $name }”用默认值：文件中写的是 { $value }，它不接受。
settings-file-unknown = 设置文件提到“{ $name }”，这个版本不认识。
settings-file-input = 设置文件把“{ $name }”绑定到 { $value }，它不是按键、按钮或滚轮。
settings-file-profile = 设置文件中的按键方案“{ $name }”被略去。
settings-file-unreadable = 设置文件 { $file } 无法读取（{ $reason }）。使用默认值，更改不会保存。
settings-file-stuck = 设置文件 { $file } 无法移开（{ $reason }）。它保持原样，更改不会保存。
settings-file-no-place = 系统没有提供存放设置的位置，因此更改不会保存。可用 --config FILE 指定。
settings-file-unsaved = 设置无法保存到 { $file }（{ $reason }）。它们在游戏结束前有效。
settings-file-more = { $count ->
   *[other] 设置文件中还有 { $count } 处无法使用。
}
settings-not-applied = 这项设置无法应用：{ $reason }
