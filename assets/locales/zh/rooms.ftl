### 游戏自带房间里能读到的文字：列表中的名称、说明句和牌子。

room-long-house-name = 长屋
room-long-house-sentence = 从外面看，这座房子长 8 米，里面的走廊却长 79 米。
room-big-house-name = 大屋
room-big-house-sentence = 这间小屋宽 4 米，里面却有一座宽 12 米的大厅，而且比小屋高一倍。
room-twelve-rooms-name = 十二个房间
room-twelve-rooms-sentence = 这座 5 米乘 5 米的房子里有十二个房间，每个都是 5 米乘 5 米。
room-nested-boxes-name = 套盒
room-nested-boxes-sentence = 四个盒子一个套着一个，每进一个你就缩小一半，于是中间的球成了一座小山。
room-four-tunnels-name = 四条隧道
room-four-tunnels-sentence = 四条隧道都长 79 米，但走过去，一条是 26 米，一条是 395 米，第三条比看上去窄，第四条比看上去矮。
room-four-tunnels-shorter-sign = 沿长度 d = +2：感觉像 26 米。
room-four-tunnels-shorter-number = 长 26 米
room-four-tunnels-longer-sign = 沿长度 d = -0.8：感觉像 395 米。
room-four-tunnels-longer-number = 长 395 米
room-four-tunnels-narrower-sign = 横向 d = +0.7：9.5 米感觉像 5.6 米。
room-four-tunnels-narrower-number = 宽 5.6 米
room-four-tunnels-lower-sign = 向上 d = +0.8：10.5 米感觉像 5.8 米。
room-four-tunnels-lower-number = 高 5.8 米
room-thesis-room-name = 论文中的房间
room-thesis-room-sentence = 走进去，你就大了一倍：这个 12 乘 8 米的大厅，对里面的人来说是 6 乘 4 米。
room-two-portals-name = 两道传送门
room-two-portals-sentence = 走进蓝门，就会从橙门出来，不管它立在哪里。
room-six-portals-name = 六道传送门
room-six-portals-sentence = 这座亭子六面敞开，从一面走出去，就从对面走进来。
room-endless-stair-name = 无尽的楼梯
room-endless-stair-sentence = 这段楼梯有十六级，往上走的人却永远走不到最后一级。
room-door-to-itself-name = 通向自己的门
room-door-to-itself-sentence = 这不是镜子，而是一扇通向自己的门，走进去的人又会走出来。
room-growing-hall-name = 让人长大的大厅
room-growing-hall-sentence = 每扇门都通向一扇大一倍的门，你也会大一倍。
room-bottomless-shaft-name = 无底的竖井
room-bottomless-shaft-sentence = 跳进这口竖井的人会永远下落，而它只有八米深。
room-falling-crate-name = 坠落的箱子
room-falling-crate-sentence = 从你来到这里起，这个箱子就一直在下落，永远不会着地；跟着跳下去，它很快就会悬在你身旁。
room-way-back-name = 回程
room-way-back-sentence = 走到这条走廊的另一头有六十米，从那里回来只有十五米。
room-closet-flat-name = 衣柜里的公寓
room-closet-flat-sentence = 这个一平方米的衣柜里有一整套公寓。
