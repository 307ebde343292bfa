<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>CoverReading</name>
    <message>
        <source>Snow %1</source>
        <translation>雪 %1</translation>
    </message>
    <message>
        <source>water %1</source>
        <translation>水 %1</translation>
    </message>
    <message>
        <source>No snow</source>
        <translation>无雪</translation>
    </message>
    <message>
        <source>surface %1</source>
        <translation>表面 %1</translation>
    </message>
    <message>
        <source>exposure %1</source>
        <translation>暴露度 %1</translation>
    </message>
</context>
<context>
    <name>Edits</name>
    <message>
        <source>Collect files</source>
        <translation>收集文件</translation>
    </message>
    <message>
        <source>Switch on %1</source>
        <translation>启用 %1</translation>
    </message>
    <message>
        <source>Switch off %1</source>
        <translation>停用 %1</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>绘制 %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Reorder nodes</source>
        <translation>重排节点</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>Set key of %1</source>
        <translation>设置关键帧：%1</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>移除关键帧：%1</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>移动关键帧</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>还原 %1</translation>
    </message>
</context>
<context>
    <name>FlowReading</name>
    <message>
        <source>Flow %1 m/s</source>
        <translation>流速 %1 m/s</translation>
    </message>
    <message>
        <source>%1 m above the ground</source>
        <translation>高出地面 %1 m</translation>
    </message>
</context>
<context>
    <name>Properties</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Place of the eye in local metres.</source>
        <translation>视点位置，局部坐标（米）。</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Point the camera looks at.</source>
        <translation>摄像机注视的点。</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>视场角</translation>
    </message>
    <message>
        <source>Vertical angle of view.</source>
        <translation>垂直视角。</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>摄像机</translation>
    </message>
    <message>
        <source>The view that pictures are rendered from.</source>
        <translation>渲染图像所用的视角。</translation>
    </message>
    <message>
        <source>Quartz</source>
        <translation>石英</translation>
    </message>
    <message>
        <source>Sand</source>
        <translation>沙</translation>
    </message>
    <message>
        <source>Soil</source>
        <translation>土壤</translation>
    </message>
    <message>
        <source>Vegetation</source>
        <translation>植被</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>岩石</translation>
    </message>
    <message>
        <source>Ice</source>
        <translation>冰</translation>
    </message>
    <message>
        <source>Asphalt</source>
        <translation>沥青</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>水</translation>
    </message>
    <message>
        <source>Base type</source>
        <translation>基础类型</translation>
    </message>
    <message>
        <source>Ground where nothing is painted.</source>
        <translation>未绘制处的地面。</translation>
    </message>
    <message>
        <source>Painted file</source>
        <translation>绘制文件</translation>
    </message>
    <message>
        <source>8-bit PNG of the terrain&apos;s size with one ground type per pixel; written when the scene is saved.</source>
        <translation>与地形同尺寸的 8 位 PNG，每像素一种地面类型；保存场景时写出。</translation>
    </message>
    <message>
        <source>Base temperature</source>
        <translation>基础温度</translation>
    </message>
    <message>
        <source>Ground temperature where nothing is painted.</source>
        <translation>未绘制处的地面温度。</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with temperatures in K; written when the scene is saved.</source>
        <translation>与地形同尺寸的 GeoTIFF，温度单位为 K；保存场景时写出。</translation>
    </message>
    <message>
        <source>Ground types</source>
        <translation>地面类型</translation>
    </message>
    <message>
        <source>Painted materials of the ground.</source>
        <translation>绘制的地面材质。</translation>
    </message>
    <message>
        <source>Ground temperature</source>
        <translation>地面温度</translation>
    </message>
    <message>
        <source>Painted temperature of the ground.</source>
        <translation>绘制的地面温度。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Width of pictures.</source>
        <translation>图像宽度。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of pictures.</source>
        <translation>图像高度。</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>采样数</translation>
    </message>
    <message>
        <source>Samples per pixel against jagged edges: 1, 2, 4 or 8.</source>
        <translation>每像素采样数，用于消除锯齿：1、2、4 或 8。</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>曝光</translation>
    </message>
    <message>
        <source>Brightness in stops: +1 is twice as bright.</source>
        <translation>以档为单位的亮度：+1 表示亮一倍。</translation>
    </message>
    <message>
        <source>Snowfall haze</source>
        <translation>降雪雾霭</translation>
    </message>
    <message>
        <source>How much of its real extinction falling snow shows in the distance: 1 is what the eye would see, less keeps the view open.</source>
        <translation>远处降雪显示其真实消光的比例：1 为肉眼所见，较小的值使视野更开阔。</translation>
    </message>
    <message>
        <source>Show flakes</source>
        <translation>显示雪花</translation>
    </message>
    <message>
        <source>Draw the falling flakes.</source>
        <translation>绘制飘落的雪花。</translation>
    </message>
    <message>
        <source>Show caption</source>
        <translation>显示说明文字</translation>
    </message>
    <message>
        <source>Print the caption and the credit line on pictures.</source>
        <translation>在图像上印出说明文字和数据来源。</translation>
    </message>
    <message>
        <source>Caption</source>
        <translation>说明文字</translation>
    </message>
    <message>
        <source>Text printed on pictures.</source>
        <translation>印在图像上的文字。</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>帧率</translation>
    </message>
    <message>
        <source>Pictures per second of film.</source>
        <translation>影片每秒的图像数。</translation>
    </message>
    <message>
        <source>Time scale</source>
        <translation>时间比例</translation>
    </message>
    <message>
        <source>Seconds of weather per second of film. Cover and mass use weather time, flakes on screen film time.</source>
        <translation>影片每秒对应的天气秒数。积雪和质量使用天气时间，屏幕上的雪花使用影片时间。</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>First frame shown and exported; the simulation itself starts at 0.</source>
        <translation>显示和导出的第一帧；模拟本身从 0 开始。</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最后一帧</translation>
    </message>
    <message>
        <source>Last frame shown and exported.</source>
        <translation>显示和导出的最后一帧。</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Start of the random numbers: same scene, same seed, same result.</source>
        <translation>随机数的起点：场景和种子相同，结果相同。</translation>
    </message>
    <message>
        <source>Exposure rays</source>
        <translation>暴露度射线</translation>
    </message>
    <message>
        <source>Rays per cover cell that measure how open it lies; the error falls with the square root.</source>
        <translation>每个积雪网格用于测量开阔程度的射线数；误差随其平方根减小。</translation>
    </message>
    <message>
        <source>New snow density</source>
        <translation>新雪密度</translation>
    </message>
    <message>
        <source>0 takes it from the air temperature.</source>
        <translation>0 表示由气温得出。</translation>
    </message>
    <message>
        <source>Holds below</source>
        <translation>保持角度</translation>
    </message>
    <message>
        <source>Slopes flatter than this keep all the snow that reaches them.</source>
        <translation>比此平缓的坡面保留全部落雪。</translation>
    </message>
    <message>
        <source>Sheds above</source>
        <translation>脱落角度</translation>
    </message>
    <message>
        <source>Slopes steeper than this keep none.</source>
        <translation>比此陡峭的坡面不保留积雪。</translation>
    </message>
    <message>
        <source>Cover noise</source>
        <translation>积雪噪声</translation>
    </message>
    <message>
        <source>Unevenness of the cover; its mean is zero.</source>
        <translation>积雪的不均匀度；其平均值为零。</translation>
    </message>
    <message>
        <source>Checkpoint every</source>
        <translation>检查点间隔</translation>
    </message>
    <message>
        <source>Frames between full saves of the state, from which an edit restarts.</source>
        <translation>两次完整状态保存之间的帧数，编辑后从那里重新开始。</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Size and look of pictures.</source>
        <translation>图像的尺寸和外观。</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Time, range and accuracy of the simulation.</source>
        <translation>模拟的时间、范围和精度。</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Raster file with the elevation model.</source>
        <translation>包含高程模型的栅格文件。</translation>
    </message>
    <message>
        <source>EPSG code</source>
        <translation>EPSG 代码</translation>
    </message>
    <message>
        <source>Coordinate system; 0 takes the one named in the file.</source>
        <translation>坐标系；0 表示采用文件中所述的坐标系。</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>网格大小</translation>
    </message>
    <message>
        <source>Distance of the heights in files without coordinates; 0 takes the file&apos;s, or 1 m.</source>
        <translation>无坐标文件中高程点的间距；0 表示取自文件，否则为 1 米。</translation>
    </message>
    <message>
        <source>Height unit</source>
        <translation>高度单位</translation>
    </message>
    <message>
        <source>Metres per unit of height in files that name no unit, such as 16-bit PNG.</source>
        <translation>未注明单位的文件（如 16 位 PNG）中每高度单位的米数。</translation>
    </message>
    <message>
        <source>Marks holes</source>
        <translation>标记空洞</translation>
    </message>
    <message>
        <source>The hole value marks cells without height, in files that cannot name one.</source>
        <translation>在无法自行注明的文件中，用空洞值标记没有高度的网格。</translation>
    </message>
    <message>
        <source>Hole value</source>
        <translation>空洞值</translation>
    </message>
    <message>
        <source>Value of cells without height, in units of the file.</source>
        <translation>没有高度的网格的值，以文件单位计。</translation>
    </message>
    <message>
        <source>Vertical scale</source>
        <translation>垂直比例</translation>
    </message>
    <message>
        <source>Factor on the heights above the lowest point.</source>
        <translation>最低点以上高度的倍数。</translation>
    </message>
    <message>
        <source>Fine cover cell</source>
        <translation>精细积雪网格</translation>
    </message>
    <message>
        <source>Size of the snow cover cells near models; elsewhere the cover has the terrain&apos;s cells.</source>
        <translation>模型附近积雪网格的大小；其他地方使用地形网格。</translation>
    </message>
    <message>
        <source>Fine cover margin</source>
        <translation>精细积雪范围</translation>
    </message>
    <message>
        <source>How far round a model the fine cover reaches.</source>
        <translation>精细积雪在模型周围延伸的距离。</translation>
    </message>
    <message>
        <source>Credit line</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>Source of the data, printed on pictures.</source>
        <translation>数据来源，印在图像上。</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>按文件所述</translation>
    </message>
    <message>
        <source>Y is up</source>
        <translation>Y 轴朝上</translation>
    </message>
    <message>
        <source>Z is up</source>
        <translation>Z 轴朝上</translation>
    </message>
    <message>
        <source>Model file (glTF, OBJ, PLY).</source>
        <translation>模型文件（glTF、OBJ、PLY）。</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>朝上的轴</translation>
    </message>
    <message>
        <source>Which way is up in the model file.</source>
        <translation>模型文件中朝上的方向。</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>Metres per unit of the file; 0 takes what the format says.</source>
        <translation>文件每单位的米数；0 表示按格式规定。</translation>
    </message>
    <message>
        <source>Place in local metres: east, north, up.</source>
        <translation>局部坐标位置（米）：东、北、上。</translation>
    </message>
    <message>
        <source>Stand on ground</source>
        <translation>立于地面</translation>
    </message>
    <message>
        <source>The height counts from the terrain under the model.</source>
        <translation>高度从模型下方的地形算起。</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Turn about the x, y and z axes, in that order.</source>
        <translation>依次绕 x、y、z 轴旋转。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Factor along each axis.</source>
        <translation>沿各轴的倍数。</translation>
    </message>
    <message>
        <source>Cover cell</source>
        <translation>积雪网格</translation>
    </message>
    <message>
        <source>Size of the snow cover cells on this model.</source>
        <translation>此模型上积雪网格的大小。</translation>
    </message>
    <message>
        <source>Catches snow</source>
        <translation>承接积雪</translation>
    </message>
    <message>
        <source>Snow lies on the parts that face up; otherwise the model only shelters what is below it.</source>
        <translation>积雪落在朝上的部分；否则模型只遮挡其下方。</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>地形</translation>
    </message>
    <message>
        <source>An elevation model; the ground of the scene.</source>
        <translation>高程模型；场景的地面。</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>An imported object: a house, a tree, a car.</source>
        <translation>导入的物体：房屋、树木、汽车。</translation>
    </message>
    <message>
        <source>Air temperature</source>
        <translation>气温</translation>
    </message>
    <message>
        <source>Temperature of the air; sets the density of new snow.</source>
        <translation>空气温度；决定新雪的密度。</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <translation>风速</translation>
    </message>
    <message>
        <source>Mean wind; tilts the fall of the snow.</source>
        <translation>平均风速；使降雪倾斜。</translation>
    </message>
    <message>
        <source>Wind from</source>
        <translation>风向</translation>
    </message>
    <message>
        <source>Direction the wind comes from: 0 north, 90 east.</source>
        <translation>风的来向：0 为北，90 为东。</translation>
    </message>
    <message>
        <source>Precipitation</source>
        <translation>降水</translation>
    </message>
    <message>
        <source>Water that falls on level ground; it rules picture and cover alike.</source>
        <translation>落在水平地面上的水量；同时决定画面和积雪。</translation>
    </message>
    <message>
        <source>Sun azimuth</source>
        <translation>太阳方位角</translation>
    </message>
    <message>
        <source>Direction of the sun from north through east.</source>
        <translation>太阳方向，从北经东计算。</translation>
    </message>
    <message>
        <source>Sun elevation</source>
        <translation>太阳高度角</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon.</source>
        <translation>太阳在地平线以上的高度。</translation>
    </message>
    <message>
        <source>Cloud cover</source>
        <translation>云量</translation>
    </message>
    <message>
        <source>0 is a clear sky, 1 an overcast one; clouds soften the sun.</source>
        <translation>0 为晴天，1 为阴天；云使阳光柔和。</translation>
    </message>
    <message>
        <source>Dendrite aggregates, unrimed</source>
        <translation>枝状聚合体，无凇附</translation>
    </message>
    <message>
        <source>Dendrite aggregates, densely rimed</source>
        <translation>枝状聚合体，重度凇附</translation>
    </message>
    <message>
        <source>Hexagonal graupel</source>
        <translation>六角霰</translation>
    </message>
    <message>
        <source>Type of snow</source>
        <translation>雪的类型</translation>
    </message>
    <message>
        <source>Sets mass and fall speed of the flakes (Locatelli and Hobbs 1974).</source>
        <translation>决定雪花的质量和下落速度（Locatelli 和 Hobbs，1974）。</translation>
    </message>
    <message>
        <source>Rate factor</source>
        <translation>强度系数</translation>
    </message>
    <message>
        <source>Factor on the weather&apos;s precipitation.</source>
        <translation>天气降水量的倍数。</translation>
    </message>
    <message>
        <source>Fall spread</source>
        <translation>下落散布</translation>
    </message>
    <message>
        <source>Half-angle of the cone of fall directions; softens the edge of shelter.</source>
        <translation>下落方向锥体的半角；使遮挡边缘柔和。</translation>
    </message>
    <message>
        <source>Flutter amplitude</source>
        <translation>飘动幅度</translation>
    </message>
    <message>
        <source>Sideways swing of a flake about its path.</source>
        <translation>雪花绕其路径的横向摆动。</translation>
    </message>
    <message>
        <source>Flutter rate</source>
        <translation>飘动频率</translation>
    </message>
    <message>
        <source>Angular rate of the swing, rad/s.</source>
        <translation>摆动的角速率，rad/s。</translation>
    </message>
    <message>
        <source>Flake box</source>
        <translation>雪花盒</translation>
    </message>
    <message>
        <source>Flakes drawn</source>
        <translation>绘制雪花数</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>天气</translation>
    </message>
    <message>
        <source>Air, wind, precipitation and sun.</source>
        <translation>空气、风、降水和太阳。</translation>
    </message>
    <message>
        <source>Snowfall</source>
        <translation>降雪</translation>
    </message>
    <message>
        <source>Falling snow and the cover it lays.</source>
        <translation>降雪及其形成的积雪。</translation>
    </message>
    <message>
        <source>Particles, PLY</source>
        <translation>粒子，PLY</translation>
    </message>
    <message>
        <source>Particles, VTP and PVD</source>
        <translation>粒子，VTP 和 PVD</translation>
    </message>
    <message>
        <source>Snow cover of the terrain, GeoTIFF</source>
        <translation>地形积雪，GeoTIFF</translation>
    </message>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG，8 位</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG，16 位</translation>
    </message>
    <message>
        <source>OpenEXR, linear, 32 bit</source>
        <translation>OpenEXR，线性，32 位</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Instances</source>
        <translation>实例</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Textures</source>
        <translation>纹理</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Lowest point</source>
        <translation>最低点</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>West, south</source>
        <translation>西，南</translation>
    </message>
    <message>
        <source>East, north</source>
        <translation>东，北</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>高程</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>无数据</translation>
    </message>
    <message>
        <source>Coordinate system</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Credit</source>
        <translation>数据来源</translation>
    </message>
    <message>
        <source>Dry snow</source>
        <translation>干雪</translation>
    </message>
    <message>
        <source>Wet snow</source>
        <translation>湿雪</translation>
    </message>
    <message>
        <source>Slush</source>
        <translation>雪浆</translation>
    </message>
    <message>
        <source>Cross fluid, thinning</source>
        <translation>Cross 流体，剪切变稀</translation>
    </message>
    <message>
        <source>Cross fluid, thickening</source>
        <translation>Cross 流体，剪切变稠</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>What flows: a preset, or custom for the numbers of a flow material node. The presets&apos; numbers and sources stand in the documentation of flow materials.</source>
        <translation>流动的是什么：预设，或取流动材料节点数值的自定义材料。预设的数值和来源见流动材料文档。</translation>
    </message>
    <message>
        <source>Flow material node that a custom material takes its numbers from.</source>
        <translation>自定义材料从中取数值的流动材料节点。</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Corners of the release area in plan, local metres east and north. It must not cross itself.</source>
        <translation>释放区在平面上的角点，局部坐标，向东和向北，单位米。轮廓不得自相交。</translation>
    </message>
    <message>
        <source>8-bit PNG of the terrain&apos;s size, 1 where the slab is released and 255 elsewhere; it adds to the outline and is written when the scene is saved.</source>
        <translation>与地形同尺寸的 8 位 PNG，雪板释放处为 1，其他为 255；与轮廓叠加，在保存场景时写入。</translation>
    </message>
    <message>
        <source>Slab depth</source>
        <translation>雪板厚度</translation>
    </message>
    <message>
        <source>Depth of the slab that breaks loose.</source>
        <translation>断裂释放的雪板厚度。</translation>
    </message>
    <message>
        <source>Vertical depth</source>
        <translation>垂直厚度</translation>
    </message>
    <message>
        <source>The depth is measured vertically; otherwise along the slope&apos;s normal, as release depths are given.</source>
        <translation>厚度沿竖直方向测量；否则沿坡面法线，这是释放厚度的通常给法。</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Density of the slab; 0 takes the material&apos;s.</source>
        <translation>雪板密度;0 取材料的密度。</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Custom material</source>
        <translation>自定义材料</translation>
    </message>
    <message>
        <source>Release time</source>
        <translation>释放时间</translation>
    </message>
    <message>
        <source>Film time at which the slab breaks loose; it is not there before.</source>
        <translation>雪板断裂的影片时间；在此之前它不存在。</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线段</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>A line such as a crest, or a disc such as a pipe&apos;s mouth.</source>
        <translation>线段如溢流口，或圆盘如管口。</translation>
    </message>
    <message>
        <source>One end of the line, or the centre of the disc.</source>
        <translation>线段的一端，或圆盘的中心。</translation>
    </message>
    <message>
        <source>Line&apos;s end</source>
        <translation>线段终点</translation>
    </message>
    <message>
        <source>The other end of the line.</source>
        <translation>线段的另一端。</translation>
    </message>
    <message>
        <source>Heights count from the terrain under each point.</source>
        <translation>高度从各点下方的地形算起。</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the disc.</source>
        <translation>圆盘的半径。</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Direction and speed at which fluid enters. Of a disc only the direction counts: its speed follows from flow and radius.</source>
        <translation>流体进入的方向和速率。对圆盘只有方向有效：速率由流量和半径得出。</translation>
    </message>
    <message>
        <source>Flow per metre</source>
        <translation>每米流量</translation>
    </message>
    <message>
        <source>Volume a second and metre of the line.</source>
        <translation>线段每米每秒的体积。</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>Volume a second of the disc.</source>
        <translation>圆盘每秒的体积。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Film time of the first inflow.</source>
        <translation>开始流入的影片时间。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Film time at which inflow ends.</source>
        <translation>停止流入的影片时间。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>长方体</translation>
    </message>
    <message>
        <source>All behind a plane, or all within a box, is taken out.</source>
        <translation>移除平面之后的一切，或长方体之内的一切。</translation>
    </message>
    <message>
        <source>A point of the plane, or the centre of the box.</source>
        <translation>平面上的一点，或长方体的中心。</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Direction from the plane to the side that stays.</source>
        <translation>从平面指向保留一侧的方向。</translation>
    </message>
    <message>
        <source>Edges of the box along x, y and z.</source>
        <translation>长方体沿 x、y、z 的边长。</translation>
    </message>
    <message>
        <source>Stands still</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>Moves by its keys</source>
        <translation>按关键帧运动</translation>
    </message>
    <message>
        <source>Moved by what hits it</source>
        <translation>受碰撞物推动</translation>
    </message>
    <message>
        <source>Model that is solid for the flow.</source>
        <translation>对流动而言是固体的模型。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Whether the body stands, follows the keys of its model, or is moved by flow, gravity and collisions.</source>
        <translation>物体静止、跟随其模型的关键帧，还是被流动、重力和碰撞推动。</translation>
    </message>
    <message>
        <source>Density of a moved body.</source>
        <translation>运动物体的密度。</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Coulomb&apos;s coefficient against flow, ground and other bodies.</source>
        <translation>对流动、地面和其他物体的库仑摩擦系数。</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>Share of the speed that a collision gives back.</source>
        <translation>碰撞后返还的速度份额。</translation>
    </message>
    <message>
        <source>Start velocity</source>
        <translation>初速度</translation>
    </message>
    <message>
        <source>Velocity of a moved body at the start.</source>
        <translation>运动物体开始时的速度。</translation>
    </message>
    <message>
        <source>Start spin</source>
        <translation>初始自转</translation>
    </message>
    <message>
        <source>Angular velocity of a moved body at the start, rad/s.</source>
        <translation>运动物体开始时的角速度，rad/s。</translation>
    </message>
    <message>
        <source>Avalanche release</source>
        <translation>雪崩释放</translation>
    </message>
    <message>
        <source>A slab of snow that breaks loose.</source>
        <translation>断裂释放的雪板。</translation>
    </message>
    <message>
        <source>Water source</source>
        <translation>水源</translation>
    </message>
    <message>
        <source>A crest or a mouth where water enters.</source>
        <translation>水流入的溢流口或管口。</translation>
    </message>
    <message>
        <source>Flow sink</source>
        <translation>流出口</translation>
    </message>
    <message>
        <source>A plane or a box that takes flow out.</source>
        <translation>移除流动的平面或长方体。</translation>
    </message>
    <message>
        <source>Rigid body</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>Makes a model solid for the flow.</source>
        <translation>使模型对流动成为固体。</translation>
    </message>
    <message>
        <source>Newtonian</source>
        <translation>牛顿</translation>
    </message>
    <message>
        <source>Power law</source>
        <translation>幂律</translation>
    </message>
    <message>
        <source>Bingham</source>
        <translation>Bingham</translation>
    </message>
    <message>
        <source>Herschel-Bulkley</source>
        <translation>Herschel-Bulkley</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>Cross</translation>
    </message>
    <message>
        <source>Frictional (Mohr-Coulomb)</source>
        <translation>摩擦型（Mohr-Coulomb）</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>本构律</translation>
    </message>
    <message>
        <source>How the viscosity follows from the shear rate. Snow is frictional: it piles up and stops.</source>
        <translation>粘度如何随剪切率变化。雪是摩擦型的：会堆积并停下。</translation>
    </message>
    <message>
        <source>Density at rest.</source>
        <translation>静止时的密度。</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>粘度</translation>
    </message>
    <message>
        <source>Newtonian viscosity, consistency in Pa s^n, or that of a Cross fluid at rest.</source>
        <translation>牛顿粘度、以 Pa s^n 计的稠度，或 Cross 流体静止时的粘度。</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>指数</translation>
    </message>
    <message>
        <source>Exponent n of the power law, Herschel-Bulkley and Cross: below 1 the first two thin.</source>
        <translation>幂律、Herschel-Bulkley 和 Cross 的指数 n：小于 1 时前两者变稀。</translation>
    </message>
    <message>
        <source>Cohesion</source>
        <translation>内聚力</translation>
    </message>
    <message>
        <source>Stress below which it does not flow without pressure: cohesion, or the yield stress.</source>
        <translation>无压力时低于此应力则不流动：内聚力或屈服应力。</translation>
    </message>
    <message>
        <source>Friction angle</source>
        <translation>摩擦角</translation>
    </message>
    <message>
        <source>Angle of internal friction; its tangent times the pressure adds to the cohesion.</source>
        <translation>内摩擦角；其正切乘以压力加到内聚力上。</translation>
    </message>
    <message>
        <source>Viscosity at speed</source>
        <translation>高速粘度</translation>
    </message>
    <message>
        <source>That of a Cross fluid in fast shear.</source>
        <translation>Cross 流体在快速剪切中的粘度。</translation>
    </message>
    <message>
        <source>Cross factor</source>
        <translation>Cross 系数</translation>
    </message>
    <message>
        <source>Cross&apos; K in s^n: how early it changes.</source>
        <translation>Cross 的 K，单位 s^n：变化来得多早。</translation>
    </message>
    <message>
        <source>Least viscosity</source>
        <translation>最小粘度</translation>
    </message>
    <message>
        <source>The viscosity is held above this.</source>
        <translation>粘度保持在此值之上。</translation>
    </message>
    <message>
        <source>Largest viscosity</source>
        <translation>最大粘度</translation>
    </message>
    <message>
        <source>The viscosity is held below this: larger values creep less at rest and ask for more steps.</source>
        <translation>粘度保持在此值之下：值越大静止时蠕动越少，需要的步数越多。</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Accurate</source>
        <translation>精确</translation>
    </message>
    <message>
        <source>Summation</source>
        <translation>求和</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>连续性</translation>
    </message>
    <message>
        <source>Friction by coefficient</source>
        <translation>按系数摩擦</translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation>粘附</translation>
    </message>
    <message>
        <source>Slides freely</source>
        <translation>自由滑动</translation>
    </message>
    <message>
        <source>Friction coefficient of flow on this type of ground. Swiss guidelines give 0.155 to 0.35 for flowing snow (Salm, Burkard and Gubler 1990).</source>
        <translation>流动在此类地面上的摩擦系数。瑞士指南对流动的雪给出 0.155 至 0.35（Salm、Burkard 和 Gubler 1990）。</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Distance of particles at rest. Half of it takes eight times the particles and sixteen times the work.</source>
        <translation>静止时粒子的间距。减半需要八倍的粒子和十六倍的计算量。</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>精度</translation>
    </message>
    <message>
        <source>Particles act on others within 2 spacings (fast) or 3 (accurate, about three times the work).</source>
        <translation>粒子的作用范围为 2 个间距（快速）或 3 个（精确，计算量约三倍）。</translation>
    </message>
    <message>
        <source>Density by</source>
        <translation>密度算法</translation>
    </message>
    <message>
        <source>Summation over neighbours, or continuity with diffusion: quieter pressure, cheaper steps.</source>
        <translation>对邻居求和，或带扩散的连续性方程：压力更平稳，步更省。</translation>
    </message>
    <message>
        <source>Sound speed</source>
        <translation>声速</translation>
    </message>
    <message>
        <source>Stiffness of the flow: larger is less compressible and takes more steps; 0 finds it.</source>
        <translation>流动的刚度：越大越不可压缩，需要的步数越多;0 自动确定。</translation>
    </message>
    <message>
        <source>Longest step</source>
        <translation>最长步长</translation>
    </message>
    <message>
        <source>Time steps are never longer than this.</source>
        <translation>时间步不会超过此值。</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Share of the neighbours&apos; velocity that a particle takes on (XSPH).</source>
        <translation>粒子采纳的邻居速度份额（XSPH）。</translation>
    </message>
    <message>
        <source>Viscosity cap</source>
        <translation>粘度上限</translation>
    </message>
    <message>
        <source>No viscosity is larger: less creep at rest asks for more steps; 0 finds one that leaves the step alone.</source>
        <translation>粘度不超过此值：静止时蠕动越少需要的步数越多;0 自动取不缩短步长的值。</translation>
    </message>
    <message>
        <source>Wind drag</source>
        <translation>风阻</translation>
    </message>
    <message>
        <source>Acceleration by the wind per square of the speed against it.</source>
        <translation>相对风速平方所对应的风致加速度。</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>How far beyond the found reach of the flow the domain goes.</source>
        <translation>区域超出所求流动范围的距离。</translation>
    </message>
    <message>
        <source>Headroom</source>
        <translation>上方空间</translation>
    </message>
    <message>
        <source>How far the domain goes above ground and sources; what flies higher leaves.</source>
        <translation>区域高出地面和源的距离；飞得更高的会离开。</translation>
    </message>
    <message>
        <source>Domain from</source>
        <translation>区域起点</translation>
    </message>
    <message>
        <source>Lowest corner of the box that flow stays in; equal corners find the box from the terrain.</source>
        <translation>流动所处长方体的最低角；两角相同则由地形确定。</translation>
    </message>
    <message>
        <source>Domain to</source>
        <translation>区域终点</translation>
    </message>
    <message>
        <source>Highest corner of the box that flow stays in.</source>
        <translation>流动所处长方体的最高角。</translation>
    </message>
    <message>
        <source>Closed domain</source>
        <translation>封闭区域</translation>
    </message>
    <message>
        <source>The sides of the domain are smooth walls; otherwise flow leaves there.</source>
        <translation>区域的侧面是光滑的墙；否则流动从那里离开。</translation>
    </message>
    <message>
        <source>Ground holds by</source>
        <translation>地面阻力方式</translation>
    </message>
    <message>
        <source>How the ground holds what flows over it.</source>
        <translation>地面如何阻滞流过的东西。</translation>
    </message>
    <message>
        <source>Turbulent friction</source>
        <translation>湍流摩擦</translation>
    </message>
    <message>
        <source>Voellmy&apos;s xi: the ground also holds by density times gravity times speed squared over xi; 0 is none. Published values are 400 to 4000 (Salm, Burkard and Gubler 1990).</source>
        <translation>Voellmy 的 xi：地面还以密度乘重力乘速度平方除以 xi 阻滞;0 表示没有。发表值为 400 至 4000（Salm、Burkard 和 Gubler 1990）。</translation>
    </message>
    <message>
        <source>Friction on quartz</source>
        <translation>石英上的摩擦</translation>
    </message>
    <message>
        <source>Friction on sand</source>
        <translation>沙上的摩擦</translation>
    </message>
    <message>
        <source>Friction on soil</source>
        <translation>土壤上的摩擦</translation>
    </message>
    <message>
        <source>Friction on vegetation</source>
        <translation>植被上的摩擦</translation>
    </message>
    <message>
        <source>Friction on rock</source>
        <translation>岩石上的摩擦</translation>
    </message>
    <message>
        <source>Friction on ice</source>
        <translation>冰上的摩擦</translation>
    </message>
    <message>
        <source>Friction on asphalt</source>
        <translation>沥青上的摩擦</translation>
    </message>
    <message>
        <source>Friction on water</source>
        <translation>水上的摩擦</translation>
    </message>
    <message>
        <source>Flow material</source>
        <translation>流动材料</translation>
    </message>
    <message>
        <source>Numbers of a custom material that flows.</source>
        <translation>自定义流动材料的数值。</translation>
    </message>
    <message>
        <source>Flow settings</source>
        <translation>流动设置</translation>
    </message>
    <message>
        <source>How avalanches and water are computed.</source>
        <translation>如何计算雪崩和水。</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>压力</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Shear rate</source>
        <translation>剪切率</translation>
    </message>
    <message>
        <source>Particle class</source>
        <translation>粒子类别</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>年龄</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>邻居数</translation>
    </message>
    <message>
        <source>Within the flow</source>
        <translation>流动内部</translation>
    </message>
    <message>
        <source>Isolated</source>
        <translation>孤立</translation>
    </message>
    <message>
        <source>At the surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>Flow shows</source>
        <translation>流动显示</translation>
    </message>
    <message>
        <source>What the colours of flowing particles tell. Material draws snow as snow and water as water.</source>
        <translation>流动粒子的颜色表示什么。材料模式把雪画成雪、把水画成水。</translation>
    </message>
    <message>
        <source>Range of the frame</source>
        <translation>按帧取范围</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s particles have; off takes the range below.</source>
        <translation>颜色铺满该帧粒子的取值；关闭则用下面的范围。</translation>
    </message>
    <message>
        <source>Range from</source>
        <translation>范围下限</translation>
    </message>
    <message>
        <source>Value of the darkest colour, in the unit that the legend shows.</source>
        <translation>最暗颜色的值，单位同图例。</translation>
    </message>
    <message>
        <source>Range to</source>
        <translation>范围上限</translation>
    </message>
    <message>
        <source>Value of the brightest colour, in the unit that the legend shows.</source>
        <translation>最亮颜色的值，单位同图例。</translation>
    </message>
    <message>
        <source>Logarithmic colours</source>
        <translation>对数颜色</translation>
    </message>
    <message>
        <source>Each step of colour multiplies the value: for viscosity and shear rate. Needs values above 0.</source>
        <translation>每级颜色按倍数增长：适用于粘度和剪切率。数值须大于 0。</translation>
    </message>
    <message>
        <source>Show legend</source>
        <translation>显示图例</translation>
    </message>
    <message>
        <source>Show boundary particles</source>
        <translation>显示边界粒子</translation>
    </message>
    <message>
        <source>Draw the particles that stand for moving bodies.</source>
        <translation>绘制代表运动物体的粒子。</translation>
    </message>
    <message>
        <source>Pause snow</source>
        <translation>暂停降雪</translation>
    </message>
    <message>
        <source>While it is on, falling snow and cover stand still and everything else goes on.</source>
        <translation>开启期间，降雪和积雪静止，其余照常进行。</translation>
    </message>
    <message>
        <source>Pause flow</source>
        <translation>暂停流动</translation>
    </message>
    <message>
        <source>While it is on, avalanches, water and bodies stand still and everything else goes on.</source>
        <translation>开启期间，雪崩、水和物体静止，其余照常进行。</translation>
    </message>
    <message>
        <source>State equation</source>
        <translation>状态方程</translation>
    </message>
    <message>
        <source>Solved for (DFSPH)</source>
        <translation>求解（DFSPH）</translation>
    </message>
    <message>
        <source>Pressure by</source>
        <translation>压力计算</translation>
    </message>
    <message>
        <source>The state equation (small, cheap steps, slightly compressible), or solved for so that the density stays: larger steps, each of many iterations.</source>
        <translation>状态方程（步小而省，略可压缩），或求解使密度保持不变：步更大，每步多次迭代。</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>抗拉强度</translation>
    </message>
    <message>
        <source>Tension that it bears before it tears: what makes wet snow hang together and roll in lumps. Acts with the equation of state.</source>
        <translation>断裂前所能承受的拉力:湿雪因此能粘在一起、成团滚动。仅在使用状态方程时起作用。</translation>
    </message>
    <message>
        <source>Old snow</source>
        <translation>旧雪</translation>
    </message>
    <message>
        <source>Depth of the snow that lies on open level ground when the film begins. It fell with the wind of the first frame: steep slopes shed it, and sheltered places have less.</source>
        <translation>影片开始时开阔水平地面上的积雪深度。它按第一帧的风降下：陡坡上的雪会滑落，有遮挡处积雪较少。</translation>
    </message>
    <message>
        <source>Density of old snow</source>
        <translation>旧雪密度</translation>
    </message>
    <message>
        <source>Density of the snow that lies when the film begins.</source>
        <translation>影片开始时积雪的密度。</translation>
    </message>
    <message>
        <source>Replaces old snow</source>
        <translation>替换旧雪</translation>
    </message>
    <message>
        <source>Lies on old snow</source>
        <translation>覆盖在旧雪上</translation>
    </message>
    <message>
        <source>Where painted</source>
        <translation>绘制处</translation>
    </message>
    <message>
        <source>Whether painted snow replaces the old snow of the snowfall or lies on top of it.</source>
        <translation>绘制的雪是替换降雪节点的旧雪，还是叠加在旧雪之上。</translation>
    </message>
    <message>
        <source>Density of the painted snow when the film begins.</source>
        <translation>影片开始时绘制的雪的密度。</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with depths in m; written when the scene is saved.</source>
        <translation>与地形同尺寸的 GeoTIFF，单位为米的雪深；保存场景时写入。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Factor on the painted share of the falling snow that is taken away.</source>
        <translation>对绘制的清除比例（占降雪的份额）的乘数。</translation>
    </message>
    <message>
        <source>Film time at which clearing begins.</source>
        <translation>开始清除的影片时间。</translation>
    </message>
    <message>
        <source>Film time at which clearing ends.</source>
        <translation>结束清除的影片时间。</translation>
    </message>
    <message>
        <source>GeoTIFF of the terrain&apos;s size with shares from 0 to 1; written when the scene is saved.</source>
        <translation>与地形同尺寸的 GeoTIFF，比例为 0 到 1；保存场景时写入。</translation>
    </message>
    <message>
        <source>Snow depth</source>
        <translation>雪深</translation>
    </message>
    <message>
        <source>Painted snow that lies when the film begins.</source>
        <translation>影片开始时已有的、绘制的雪。</translation>
    </message>
    <message>
        <source>Keep clear</source>
        <translation>保持无雪</translation>
    </message>
    <message>
        <source>Painted ground where falling snow is taken away: ploughed roads, heated yards.</source>
        <translation>绘制的、清除降雪的地面：犁过的道路、加热的院子。</translation>
    </message>
    <message>
        <source>Ground type</source>
        <translation>地面类型</translation>
    </message>
    <message>
        <source>Blur</source>
        <translation>模糊</translation>
    </message>
    <message>
        <source>Softens edges; what is not painted stays so.</source>
        <translation>柔化边缘；未绘制处保持不变。</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>中值</translation>
    </message>
    <message>
        <source>Takes specks away and keeps edges.</source>
        <translation>去除斑点并保留边缘。</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>扩张</translation>
    </message>
    <message>
        <source>High values and painted areas grow.</source>
        <translation>高值和已绘制区域扩张。</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>收缩</translation>
    </message>
    <message>
        <source>High values and painted areas shrink.</source>
        <translation>高值和已绘制区域收缩。</translation>
    </message>
    <message>
        <source>Remove specks</source>
        <translation>去除斑点</translation>
    </message>
    <message>
        <source>Shrinks, then grows: small areas vanish.</source>
        <translation>先收缩后扩张：小区域消失。</translation>
    </message>
    <message>
        <source>Fill gaps</source>
        <translation>填补缝隙</translation>
    </message>
    <message>
        <source>Grows, then shrinks: small gaps close.</source>
        <translation>先扩张后收缩：小缝隙被填补。</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Shares become all or nothing; of other layers what is less is taken away.</source>
        <translation>比例变为全有或全无；其他图层中较小的值被移除。</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>反转</translation>
    </message>
    <message>
        <source>What was full becomes empty and the other way round.</source>
        <translation>满变为空，空变为满。</translation>
    </message>
    <message>
        <source>Free cluster</source>
        <translation>自由团簇</translation>
    </message>
    <message>
        <source>Six arms</source>
        <translation>六臂</translation>
    </message>
    <message>
        <source>Eight arms</source>
        <translation>八臂</translation>
    </message>
    <message>
        <source>Crystal</source>
        <translation>晶体</translation>
    </message>
    <message>
        <source>Fern-like star</source>
        <translation>蕨状星形</translation>
    </message>
    <message>
        <source>Plain star</source>
        <translation>简单星形</translation>
    </message>
    <message>
        <source>Star with broad branches</source>
        <translation>宽枝星形</translation>
    </message>
    <message>
        <source>Plate with corners</source>
        <translation>带角板状</translation>
    </message>
    <message>
        <source>32 pixels</source>
        <translation>32 像素</translation>
    </message>
    <message>
        <source>64 pixels</source>
        <translation>64 像素</translation>
    </message>
    <message>
        <source>128 pixels</source>
        <translation>128 像素</translation>
    </message>
    <message>
        <source>256 pixels</source>
        <translation>256 像素</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>生长方式</translation>
    </message>
    <message>
        <source>Free cluster, six and eight arms grow by diffusion-limited aggregation, crystals by a lattice automaton.</source>
        <translation>自由团簇、六臂和八臂通过扩散限制聚集生长,晶体由格点自动机生长。</translation>
    </message>
    <message>
        <source>Shapes</source>
        <translation>形状数</translation>
    </message>
    <message>
        <source>Number of different flakes that are grown.</source>
        <translation>生长出的不同雪花的数量。</translation>
    </message>
    <message>
        <source>Another number grows other flakes of the same kind.</source>
        <translation>换一个数会生长出同类的其他雪花。</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>Radius to which the smallest flake grows.</source>
        <translation>最小的雪花生长到的半径。</translation>
    </message>
    <message>
        <source>Largest radius</source>
        <translation>最大半径</translation>
    </message>
    <message>
        <source>Radius to which the largest flake grows.</source>
        <translation>最大的雪花生长到的半径。</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>细节</translation>
    </message>
    <message>
        <source>Size of a flake&apos;s pictures; close-ups want fine ones.</source>
        <translation>雪花图像的大小;特写需要精细的图像。</translation>
    </message>
    <message>
        <source>Particle</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>Diameter of the particles that aggregate; the finer, the more branches. Not for crystals.</source>
        <translation>聚集粒子的直径;越细,分枝越多。不适用于晶体。</translation>
    </message>
    <message>
        <source>Most particles</source>
        <translation>最多粒子数</translation>
    </message>
    <message>
        <source>A flake that has as many stops growing. Not for crystals.</source>
        <translation>达到这个数量的雪花停止生长。不适用于晶体。</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>How far particles turn to the crystal&apos;s own directions: 0 gives corals, 1 branches at 60 degrees. For six and eight arms.</source>
        <translation>粒子转向晶体自身方向的程度:0 得到珊瑚状,1 得到 60 度分枝。适用于六臂和八臂。</translation>
    </message>
    <message>
        <source>Landings</source>
        <translation>着陆次数</translation>
    </message>
    <message>
        <source>Particles that must land at a place before one stays: more give straighter arms. For six and eight arms.</source>
        <translation>一处须有多少粒子着陆后才留下一个:越多臂越直。适用于六臂和八臂。</translation>
    </message>
    <message>
        <source>Form of crystals</source>
        <translation>晶体形态</translation>
    </message>
    <message>
        <source>Habit of the crystals that the automaton grows.</source>
        <translation>自动机生长的晶体的习性。</translation>
    </message>
    <message>
        <source>Cells of crystals</source>
        <translation>晶体格数</translation>
    </message>
    <message>
        <source>Lattice cells from the middle to the tips: more give finer branches, and take longer.</source>
        <translation>从中心到尖端的格数:越多分枝越细,耗时越长。</translation>
    </message>
    <message>
        <source>Variety of crystals</source>
        <translation>晶体多样性</translation>
    </message>
    <message>
        <source>How much the air changes while a crystal grows; it makes each one its own.</source>
        <translation>晶体生长期间空气变化的程度;它使每个晶体各不相同。</translation>
    </message>
    <message>
        <source>Flake shapes</source>
        <translation>雪花形状</translation>
    </message>
    <message>
        <source>Shapes of the falling flakes: what grows is what falls.</source>
        <translation>飘落雪花的形状:生长出什么就飘落什么。</translation>
    </message>
    <message>
        <source>Drag and flutter</source>
        <translation>阻力与飘摆</translation>
    </message>
    <message>
        <source>Decaying sine</source>
        <translation>衰减正弦</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>Drag and flutter: flakes follow the wind and swing steadily. Decaying sine: they fall at their terminal speed and swing in bursts that die away, wider and faster in wind.</source>
        <translation>阻力与飘摆:雪花随风而行并稳定摆动。衰减正弦:雪花以终端速度下落,成阵摆动并逐渐减弱,有风时摆幅更大更快。</translation>
    </message>
    <message>
        <source>Gustiness</source>
        <translation>阵风强度</translation>
    </message>
    <message>
        <source>Strength of the gusts as a share of the mean wind: 0.1 over water, 0.2 in the open, 0.3 and more among houses and trees.</source>
        <translation>阵风强度占平均风的比例:水面 0.1,开阔地 0.2,房屋和树木之间 0.3 以上。</translation>
    </message>
    <message>
        <source>Size of gusts</source>
        <translation>阵风尺度</translation>
    </message>
    <message>
        <source>Wavelength of the largest eddies in the wind.</source>
        <translation>风中最大涡旋的波长。</translation>
    </message>
    <message>
        <source>Edge of the box round the camera in which flakes are drawn; beyond it snow is haze.</source>
        <translation>相机周围绘制雪花的盒子的边长;盒外的雪表现为雾霭。</translation>
    </message>
    <message>
        <source>Distance groups</source>
        <translation>距离分组</translation>
    </message>
    <message>
        <source>Shells round the camera: the farther one is, the fewer and larger its flakes, so that each hides as much of what is behind it as the precipitation asks for.</source>
        <translation>相机周围的壳层:越远的雪花越少越大,使每层按降水量遮挡其后的景物。</translation>
    </message>
    <message>
        <source>Number of flakes in the box; each stands for as many real ones as the precipitation asks for. The more, the finer the snow.</source>
        <translation>盒内雪花的数量;每个代表降水量所需的若干真实雪花。越多,雪越细密。</translation>
    </message>
    <message>
        <source>Near size limit</source>
        <translation>近处大小限制</translation>
    </message>
    <message>
        <source>Constant A of the size on screen, h S / sqrt(A + B D + C D^2), C being the lens: keeps near flakes small. 0 is perspective as it is.</source>
        <translation>屏幕大小公式 h S / sqrt(A + B D + C D^2) 中的常数 A(C 取决于镜头):使近处雪花保持较小。0 为原本的透视。</translation>
    </message>
    <message>
        <source>Size falloff</source>
        <translation>大小衰减</translation>
    </message>
    <message>
        <source>Linear term B of the size on screen: flakes shrink faster with the distance D at first. 0 is perspective as it is.</source>
        <translation>屏幕大小公式的线性项 B:雪花起初随距离 D 缩小得更快。0 为原本的透视。</translation>
    </message>
    <message>
        <source>Energy balance</source>
        <translation>能量平衡</translation>
    </message>
    <message>
        <source>Degree-day</source>
        <translation>度日法</translation>
    </message>
    <message>
        <source>Tang and Zhang, as published</source>
        <translation>Tang 和 Zhang（按原文）</translation>
    </message>
    <message>
        <source>Lies as it fell</source>
        <translation>保持降下时的状态</translation>
    </message>
    <message>
        <source>Melt</source>
        <translation>融化</translation>
    </message>
    <message>
        <source>Energy balance: sun, sky, air, rain and ground, settling and refreezing. Degree-day: by the air&apos;s temperature alone. As published: the law of Tang and Zhang, for comparison; it knows no heat of melting. Lies as it fell: snow neither settles nor melts.</source>
        <translation>能量平衡：太阳、天空、空气、雨和地面，以及沉降和再冻结。度日法：仅由气温决定。按原文：Tang 和 Zhang 的定律，供比较；不考虑融化热。保持降下时的状态：雪既不沉降也不融化。</translation>
    </message>
    <message>
        <source>Degree-day factor</source>
        <translation>度日因子</translation>
    </message>
    <message>
        <source>Water that melts per day and degree above the threshold; 2 to 6 are usual.</source>
        <translation>气温每高出阈值一度，每天融化的水量；通常为 2 至 6。</translation>
    </message>
    <message>
        <source>Degree-day threshold</source>
        <translation>度日法阈值</translation>
    </message>
    <message>
        <source>Air temperature above which snow melts.</source>
        <translation>高于此气温时雪融化。</translation>
    </message>
    <message>
        <source>Albedo of new snow</source>
        <translation>新雪反照率</translation>
    </message>
    <message>
        <source>Share of the sun&apos;s light that new snow sends back.</source>
        <translation>新雪反射的太阳光比例。</translation>
    </message>
    <message>
        <source>Albedo of old snow</source>
        <translation>旧雪反照率</translation>
    </message>
    <message>
        <source>What the albedo of ageing snow falls to.</source>
        <translation>老化的雪的反照率最终降到的值。</translation>
    </message>
    <message>
        <source>Height of the wind</source>
        <translation>测风高度</translation>
    </message>
    <message>
        <source>Above ground, at which the wind is measured.</source>
        <translation>测量风速处的离地高度。</translation>
    </message>
    <message>
        <source>Height of the temperature</source>
        <translation>测温高度</translation>
    </message>
    <message>
        <source>Above ground, at which temperature and humidity are.</source>
        <translation>温度和湿度所对应的离地高度。</translation>
    </message>
    <message>
        <source>Slopes and shadow</source>
        <translation>坡面与阴影</translation>
    </message>
    <message>
        <source>Where a sun melts, it and the sky count by slope, aspect and horizon; off: everything lies level and open.</source>
        <translation>有融雪日照时，太阳和天空的作用按坡度、坡向和地平线计算；关闭：一切视为水平且开阔。</translation>
    </message>
    <message>
        <source>Horizon reach</source>
        <translation>地平线范围</translation>
    </message>
    <message>
        <source>How far away mountains cast shadow.</source>
        <translation>山体投下阴影的最远距离。</translation>
    </message>
    <message>
        <source>Place in local metres: east, north; it lies on the ground.</source>
        <translation>局部坐标位置（米）：东、北；位于地面上。</translation>
    </message>
    <message>
        <source>How far it warms; the heat fades towards the edge.</source>
        <translation>加热的范围；热量向边缘减弱。</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>功率</translation>
    </message>
    <message>
        <source>Heat that goes into the ground at the centre; 100 W/m² melts 26 mm of water a day.</source>
        <translation>中心处传入地面的热量；100 W/m² 每天融化 26 mm 水当量。</translation>
    </message>
    <message>
        <source>Snow cover</source>
        <translation>积雪</translation>
    </message>
    <message>
        <source>How lying snow settles, ages and melts.</source>
        <translation>地面积雪如何沉降、老化和融化。</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Warm ground on which less snow stays.</source>
        <translation>温暖的地面，留存的雪较少。</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>射线</translation>
    </message>
    <message>
        <source>Occlusion maps</source>
        <translation>遮挡图</translation>
    </message>
    <message>
        <source>Shelter by</source>
        <translation>遮挡算法</translation>
    </message>
    <message>
        <source>Rays: exact but for the number of rays. Maps: pictures of the scene along a few directions of fall, quicker with many triangles and moving things, and a little coarse at edges.</source>
        <translation>射线：除射线数量有限外是精确的。遮挡图：沿若干下落方向绘制的场景图像，三角形多、有运动物体时更快，边缘略粗糙。</translation>
    </message>
    <message>
        <source>Map directions</source>
        <translation>遮挡图方向数</translation>
    </message>
    <message>
        <source>Directions of fall that maps are drawn for; few give stepped edges of shelter.</source>
        <translation>绘制遮挡图的下落方向数量；太少会使遮挡边缘呈阶梯状。</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>遮挡图大小</translation>
    </message>
    <message>
        <source>Texels along a map at most; small ground takes as many as half a cell asks for.</source>
        <translation>遮挡图每边的最大纹素数；较小的地面按每纹素半个网格取用。</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>What the snow lies on: how well it conducts heat, how dark it is.</source>
        <translation>雪所覆盖的表面：导热性如何，颜色有多深。</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>热量</translation>
    </message>
    <message>
        <source>Heat that comes up through the surface: 10 for a house, 100 melts 26 mm of water a day.</source>
        <translation>从下方穿过表面的热量：房屋为 10；100 每天融化 26 mm 水当量。</translation>
    </message>
    <message>
        <source>Dusting</source>
        <translation>薄雪</translation>
    </message>
    <message>
        <source>In pictures, how much of the snow of the ground beside it shows on what faces up: for trees and small things in great numbers that catch no snow of their own.</source>
        <translation>图像中朝上的部分显示旁边地面积雪的多少：用于自身不承接积雪的树木和大量小物体。</translation>
    </message>
    <message>
        <source>Fine cover round it</source>
        <translation>周围精细积雪</translation>
    </message>
    <message>
        <source>The ground round the model has small cover cells, so that lee and eaves show; off for what stands far away or in great numbers.</source>
        <translation>模型周围的地面使用小的积雪网格，以显现背风处和屋檐；远处或大量的物体请关闭。</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>副本</translation>
    </message>
    <message>
        <source>Places (east, north) at which the model stands once more.</source>
        <translation>模型再次放置的位置（东、北）。</translation>
    </message>
    <message>
        <source>Turn of copies</source>
        <translation>副本旋转</translation>
    </message>
    <message>
        <source>Range within which copies are turned at random.</source>
        <translation>副本随机旋转的范围。</translation>
    </message>
    <message>
        <source>Size of copies</source>
        <translation>副本大小</translation>
    </message>
    <message>
        <source>Share by which copies are larger or smaller at random: 0.2 gives 0.8 to 1.2.</source>
        <translation>副本随机放大或缩小的比例：0.2 得到 0.8 至 1.2。</translation>
    </message>
    <message>
        <source>Seed of copies</source>
        <translation>副本随机种子</translation>
    </message>
    <message>
        <source>Another number turns and scales the copies otherwise.</source>
        <translation>换一个数会使副本的旋转和缩放不同。</translation>
    </message>
    <message>
        <source>Always snow</source>
        <translation>始终为雪</translation>
    </message>
    <message>
        <source>Snow or rain by temperature</source>
        <translation>按温度为雪或雨</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>As in pictures</source>
        <translation>与图像一致</translation>
    </message>
    <message>
        <source>By date</source>
        <translation>按日期</translation>
    </message>
    <message>
        <source>Falls as</source>
        <translation>降水形态</translation>
    </message>
    <message>
        <source>Snow whatever the air&apos;s temperature, or at every place what its air and humidity make of it.</source>
        <translation>无论气温如何都为雪，或在各处由当地的气温和湿度决定。</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>湿度</translation>
    </message>
    <message>
        <source>Relative humidity of the air; dry air lets snow vanish without melting.</source>
        <translation>空气的相对湿度；干燥的空气使雪不经融化而消失。</translation>
    </message>
    <message>
        <source>Station record</source>
        <translation>气象站记录</translation>
    </message>
    <message>
        <source>Text file of a weather station, a row per step: year, month, day, hour (UTC), shortwave and longwave W/m2, snowfall and rainfall kg/(m2 s), air temperature K, humidity %, wind m/s, pressure Pa. It replaces the values above but the wind&apos;s direction and the speed that tilts the fall.</source>
        <translation>气象站的文本文件，每步一行：年、月、日、时（UTC），短波和长波辐射 W/m2，降雪和降雨 kg/(m2 s)，气温 K，湿度 %，风速 m/s，气压 Pa。它替换上面的值，但风向和使降雪倾斜的风速除外。</translation>
    </message>
    <message>
        <source>Film begins</source>
        <translation>影片开始</translation>
    </message>
    <message>
        <source>Date and time (UTC) at which the film begins, as 2005-10-01 00:00. Empty: at the begin of the station record.</source>
        <translation>影片开始的日期和时间（UTC），格式如 2005-10-01 00:00。留空：从气象站记录的起点开始。</translation>
    </message>
    <message>
        <source>Sun that melts</source>
        <translation>融雪的太阳</translation>
    </message>
    <message>
        <source>None: as at night or under the thickest cloud. As in pictures: the sun that azimuth and elevation set. By date: where date and place put it, with day, season and the shadow of mountains.</source>
        <translation>无：如夜间或最厚的云层之下。与图像一致：由方位角和高度角设定的太阳。按日期：由日期和地点决定位置，含昼夜、季节和山体阴影。</translation>
    </message>
    <message>
        <source>Sun of the date lights</source>
        <translation>以日期的太阳照明</translation>
    </message>
    <message>
        <source>Pictures have the sun of date and place, nights too; off: azimuth and elevation.</source>
        <translation>图像使用日期和地点对应的太阳，也有夜晚；关闭：使用方位角和高度角。</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>纬度</translation>
    </message>
    <message>
        <source>Of the scene, north positive; for the sun.</source>
        <translation>场景的纬度，北纬为正；用于太阳。</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>经度</translation>
    </message>
    <message>
        <source>Of the scene, east positive; for the sun.</source>
        <translation>场景的经度，东经为正；用于太阳。</translation>
    </message>
    <message>
        <source>Weather of an altitude</source>
        <translation>指定海拔的天气</translation>
    </message>
    <message>
        <source>The weather was measured at the altitude below; off: at the terrain&apos;s lowest point.</source>
        <translation>天气在下面的海拔处测得；关闭：在地形的最低点。</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>海拔</translation>
    </message>
    <message>
        <source>Height above sea level at which the weather was measured.</source>
        <translation>测量天气处的海拔高度。</translation>
    </message>
    <message>
        <source>Cooling upwards</source>
        <translation>气温随高度递减</translation>
    </message>
    <message>
        <source>How much colder the air is higher up; 6.5 K/km is usual, 0 gives one temperature.</source>
        <translation>空气随高度变冷的程度；通常为 6.5 K/km，0 表示各处温度相同。</translation>
    </message>
    <message>
        <source>More precipitation upwards</source>
        <translation>降水随高度递增</translation>
    </message>
    <message>
        <source>How much more falls higher up, as a share of what falls where the weather was measured.</source>
        <translation>高处降水增加的量，以天气测量处降水量的比例表示。</translation>
    </message>
    <message>
        <source>Snow slides</source>
        <translation>积雪滑落</translation>
    </message>
    <message>
        <source>Snow that lies steeper than its angle of repose moves down, off roofs too.</source>
        <translation>比休止角更陡的积雪会向下滑落，屋顶上的也是。</translation>
    </message>
    <message>
        <source>Repose of dry snow</source>
        <translation>干雪休止角</translation>
    </message>
    <message>
        <source>Steepest slope that loose dry snow keeps.</source>
        <translation>松散干雪能保持的最陡坡度。</translation>
    </message>
    <message>
        <source>Repose of slush</source>
        <translation>雪浆休止角</translation>
    </message>
    <message>
        <source>Steepest slope that snow with 15 % of liquid water by volume keeps; moist snow with less than 3 % keeps what dry snow does.</source>
        <translation>液态水占体积 15% 的雪能保持的最陡坡度；低于 3% 的潮雪与干雪相同。</translation>
    </message>
    <message>
        <source>Width of hollows in the snow&apos;s surface that fill within a day; 0 keeps them.</source>
        <translation>雪面上一天之内被填平的凹陷的宽度；0 表示保留凹陷。</translation>
    </message>
    <message>
        <source>Snow drifts</source>
        <translation>风吹雪</translation>
    </message>
    <message>
        <source>The wind carries snow along the ground: it takes it up where it speeds up and lays it down in the lee.</source>
        <translation>风沿地面搬运积雪：在风加速处带走，在背风处堆积。</translation>
    </message>
    <message>
        <source>Drifts from</source>
        <translation>起动风速</translation>
    </message>
    <message>
        <source>Wind 10 m above ground from which snow drifts. 0 takes it from air temperature, wetness and density.</source>
        <translation>积雪开始被吹动的地面以上 10 米处风速。0 表示由气温、湿度和密度决定。</translation>
    </message>
    <message>
        <source>Drift over the border</source>
        <translation>边界吹入量</translation>
    </message>
    <message>
        <source>Share of what the wind can carry that blows in over the scene&apos;s windward border: 1 where the snow goes on beyond it, 0 where nothing comes.</source>
        <translation>从场景迎风边界吹入的雪占风所能搬运量的比例：1 表示边界外也有积雪，0 表示没有雪吹入。</translation>
    </message>
    <message>
        <source>Natural colours</source>
        <translation>自然颜色</translation>
    </message>
    <message>
        <source>Snow water equivalent</source>
        <translation>雪水当量</translation>
    </message>
    <message>
        <source>Snow density</source>
        <translation>雪密度</translation>
    </message>
    <message>
        <source>Surface temperature</source>
        <translation>表面温度</translation>
    </message>
    <message>
        <source>Liquid water in the snow</source>
        <translation>雪中液态水</translation>
    </message>
    <message>
        <source>Exposure to snowfall</source>
        <translation>降雪暴露度</translation>
    </message>
    <message>
        <source>Physically based</source>
        <translation>基于物理</translation>
    </message>
    <message>
        <source>Blinn-Phong, as published</source>
        <translation>Blinn-Phong(按发表形式)</translation>
    </message>
    <message>
        <source>Snow shows</source>
        <translation>雪显示</translation>
    </message>
    <message>
        <source>What the colours of the snow cover tell, on the ground and on models. Natural colours draw it as snow; ground that has no value is grey.</source>
        <translation>地面和模型上积雪的颜色表示什么。自然颜色按雪绘制;没有数值的地面为灰色。</translation>
    </message>
    <message>
        <source>Range of the frame&apos;s snow</source>
        <translation>按帧内积雪取范围</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s cover has; off takes the range below, the same for all frames.</source>
        <translation>将颜色分布到该帧积雪的取值上;关闭时采用下面的范围,各帧相同。</translation>
    </message>
    <message>
        <source>Snow range from</source>
        <translation>雪范围下限</translation>
    </message>
    <message>
        <source>Snow range to</source>
        <translation>雪范围上限</translation>
    </message>
    <message>
        <source>Snow shading</source>
        <translation>雪的着色</translation>
    </message>
    <message>
        <source>Physically based snow scatters light below its surface and is bluish in the shade. The published model adds ambient, diffuse and mirrored light, and mixes snow with what lies below by the exposure.</source>
        <translation>基于物理的雪在表面以下散射光线,阴影处偏蓝。发表的模型将环境光、漫反射光和镜面光相加,并按暴露度将雪与其下的物体混合。</translation>
    </message>
    <message>
        <source>Ambient reflection</source>
        <translation>环境反射</translation>
    </message>
    <message>
        <source>K_a of the published shading: share of the sky&apos;s light that snow reflects.</source>
        <translation>发表着色中的 K_a:雪反射天空光的比例。</translation>
    </message>
    <message>
        <source>Diffuse reflection</source>
        <translation>漫反射</translation>
    </message>
    <message>
        <source>K_d of the published shading: share of the sun&apos;s light that snow reflects to all sides.</source>
        <translation>发表着色中的 K_d:雪向各方向反射太阳光的比例。</translation>
    </message>
    <message>
        <source>Mirror reflection</source>
        <translation>镜面反射</translation>
    </message>
    <message>
        <source>K_s of the published shading: share of the sun&apos;s light in the highlight.</source>
        <translation>发表着色中的 K_s:高光中太阳光的比例。</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>光泽度</translation>
    </message>
    <message>
        <source>n of the published shading: the higher, the smaller the highlight.</source>
        <translation>发表着色中的 n:越大高光越小。</translation>
    </message>
    <message>
        <source>Mist and powder, OpenVDB</source>
        <translation>水雾和雪雾，OpenVDB</translation>
    </message>
    <message>
        <source>Mist density</source>
        <translation>雾的密度</translation>
    </message>
    <message>
        <source>Mist velocity</source>
        <translation>雾的速度</translation>
    </message>
    <message>
        <source>Excess temperature</source>
        <translation>相对周围的温差</translation>
    </message>
    <message>
        <source>Divergence</source>
        <translation>散度</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Across x</source>
        <translation>垂直于 x</translation>
    </message>
    <message>
        <source>Across y</source>
        <translation>垂直于 y</translation>
    </message>
    <message>
        <source>Across z</source>
        <translation>垂直于 z</translation>
    </message>
    <message>
        <source>Print what the colours of flow, snow and air mean where they stand for values.</source>
        <translation>在流动、雪和空气的颜色表示数值时,标注其含义。</translation>
    </message>
    <message>
        <source>Air shows</source>
        <translation>空气显示</translation>
    </message>
    <message>
        <source>What the colours of mist and powder in the air tell: mass per volume, speed, how much warmer than the air around, or what the pressure solver left of the divergence. Natural colours draw them as they look.</source>
        <translation>空气中水雾和雪粉的颜色表示什么:单位体积的质量、速度、比周围空气高出的温度,或压力求解后剩余的散度。自然颜色按其外观绘制。</translation>
    </message>
    <message>
        <source>Air slice</source>
        <translation>空气切片</translation>
    </message>
    <message>
        <source>Show the values of the air on a plane across this axis instead of in the whole cloud. Needs a value to show.</source>
        <translation>在垂直于此轴的平面上显示空气的数值,而不是在整个云团中显示。需要先选择要显示的数值。</translation>
    </message>
    <message>
        <source>Slice at</source>
        <translation>切片位置</translation>
    </message>
    <message>
        <source>Where the plane stands on its axis.</source>
        <translation>平面在其轴上的位置。</translation>
    </message>
    <message>
        <source>Range of the frame&apos;s air</source>
        <translation>按帧内空气取范围</translation>
    </message>
    <message>
        <source>Spread the colours over what the frame&apos;s air has; off takes the range below, the same for all frames.</source>
        <translation>将颜色分布到该帧空气的取值上;关闭时采用下面的范围,各帧相同。</translation>
    </message>
    <message>
        <source>Air range from</source>
        <translation>空气范围下限</translation>
    </message>
    <message>
        <source>Air range to</source>
        <translation>空气范围上限</translation>
    </message>
    <message>
        <source>Semi-Lagrangian</source>
        <translation>半拉格朗日</translation>
    </message>
    <message>
        <source>MacCormack</source>
        <translation>MacCormack</translation>
    </message>
    <message>
        <source>Cubic</source>
        <translation>三次插值</translation>
    </message>
    <message>
        <source>Conjugate gradients with multigrid</source>
        <translation>共轭梯度（多重网格预处理）</translation>
    </message>
    <message>
        <source>Jacobi sweeps</source>
        <translation>Jacobi 迭代</translation>
    </message>
    <message>
        <source>Gauss-Seidel sweeps</source>
        <translation>Gauss-Seidel 迭代</translation>
    </message>
    <message>
        <source>Density of humid air and its load</source>
        <translation>湿空气及其载荷的密度</translation>
    </message>
    <message>
        <source>Difference of stacked cells</source>
        <translation>上下单元之差</translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation>雾密度</translation>
    </message>
    <message>
        <source>Edge of the air&apos;s cells; 0 takes four spacings of the flow. Half of it takes eight times the cells.</source>
        <translation>空气单元的边长；0 表示取流动粒子间距的四倍。边长减半，单元数为八倍。</translation>
    </message>
    <message>
        <source>Exchange every</source>
        <translation>交换间隔</translation>
    </message>
    <message>
        <source>Longest film time from one exchange between flow and air to the next; longer frames are cut.</source>
        <translation>流动与空气两次交换之间的最长影片时间；更长的帧会被分段。</translation>
    </message>
    <message>
        <source>Advection</source>
        <translation>平流</translation>
    </message>
    <message>
        <source>How the wind of the cloud is carried along: semi-Lagrangian as published, or one of two sharper schemes.</source>
        <translation>云中气流的输运方式：按原文的半拉格朗日，或两种更锐利的格式之一。</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>反射</translation>
    </message>
    <message>
        <source>Two projections a step keep eddies alive that one would damp.</source>
        <translation>每步两次投影可保留一次投影会衰减的涡旋。</translation>
    </message>
    <message>
        <source>Pressure solver</source>
        <translation>压力求解器</translation>
    </message>
    <message>
        <source>How the pressure is found: to the tolerance, or by a fixed number of sweeps as published.</source>
        <translation>压力的求解方式：达到容差，或按原文用固定次数的迭代。</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Residual of the pressure over its right side, at most.</source>
        <translation>压力方程残差与右端项之比的上限。</translation>
    </message>
    <message>
        <source>Lift by</source>
        <translation>浮力依据</translation>
    </message>
    <message>
        <source>What makes the cloud rise or sink: the density of humid air with its load, or one of two published forms.</source>
        <translation>云上升或下沉的原因：湿空气及其载荷的密度，或两种已发表的形式之一。</translation>
    </message>
    <message>
        <source>How far the air reaches beyond the sides of the flow&apos;s box.</source>
        <translation>空气范围超出流动区域侧面的距离。</translation>
    </message>
    <message>
        <source>How far the air reaches above the flow&apos;s box; what rises higher leaves.</source>
        <translation>空气范围高出流动区域的高度；升得更高的即离开。</translation>
    </message>
    <message>
        <source>Eddy viscosity</source>
        <translation>涡粘性</translation>
    </message>
    <message>
        <source>Mist evaporates</source>
        <translation>水雾蒸发</translation>
    </message>
    <message>
        <source>Mist and vapour seek saturation: mist thins out in dry air and forms where moist air cools.</source>
        <translation>水雾与水汽趋向饱和：水雾在干空气中变稀，在湿空气冷却处生成。</translation>
    </message>
    <message>
        <source>Mist droplets</source>
        <translation>雾滴</translation>
    </message>
    <message>
        <source>Diameter of the droplets of mist: they sink and scatter light by it.</source>
        <translation>雾滴直径：决定其下沉和散射光的方式。</translation>
    </message>
    <message>
        <source>Powder grains</source>
        <translation>粉雪颗粒</translation>
    </message>
    <message>
        <source>Diameter of the grains of powder snow.</source>
        <translation>粉雪颗粒的直径。</translation>
    </message>
    <message>
        <source>Water temperature</source>
        <translation>水温</translation>
    </message>
    <message>
        <source>Temperature of all water that flows: warmer than the air its mist rises, colder it hugs the ground.</source>
        <translation>所有流水的温度：比空气暖则水雾上升，比空气冷则贴近地面。</translation>
    </message>
    <message>
        <source>Water warms air</source>
        <translation>水加热空气</translation>
    </message>
    <message>
        <source>The surface of water and its drops give heat and vapour to the air that passes, or take them.</source>
        <translation>水面和水滴向流过的空气给出热量和水汽，或从中吸取。</translation>
    </message>
    <message>
        <source>Impact from</source>
        <translation>撞击阈值</translation>
    </message>
    <message>
        <source>Acceleration from which a particle counts as hitting something.</source>
        <translation>粒子被视为发生撞击的加速度下限。</translation>
    </message>
    <message>
        <source>Mist by impact</source>
        <translation>撞击成雾</translation>
    </message>
    <message>
        <source>Share of water that an impact turns to mist per metre a second of speed that it takes.</source>
        <translation>撞击每消去 1 米/秒的速度，转化为水雾的水的比例。</translation>
    </message>
    <message>
        <source>Powder by impact</source>
        <translation>撞击成粉雪</translation>
    </message>
    <message>
        <source>Share of snow that an impact turns to powder per metre a second of speed that it takes.</source>
        <translation>撞击每消去 1 米/秒的速度，转化为粉雪的雪的比例。</translation>
    </message>
    <message>
        <source>Mist from</source>
        <translation>成雾速度</translation>
    </message>
    <message>
        <source>Mist rate</source>
        <translation>成雾速率</translation>
    </message>
    <message>
        <source>Share of the particles at the surface of water that turns to mist a second, at three times that speed.</source>
        <translation>在该速度的三倍时，水面粒子每秒转化为水雾的比例。</translation>
    </message>
    <message>
        <source>Powder from</source>
        <translation>扬雪速度</translation>
    </message>
    <message>
        <source>Powder rate</source>
        <translation>扬雪速率</translation>
    </message>
    <message>
        <source>Share of the particles at the surface of snow that turns to powder a second, at three times that speed.</source>
        <translation>在该速度的三倍时，雪面粒子每秒转化为粉雪的比例。</translation>
    </message>
    <message>
        <source>Most given</source>
        <translation>最大给出比例</translation>
    </message>
    <message>
        <source>Share of its mass that a particle in the flow gives to the air at most.</source>
        <translation>流动中的粒子最多给予空气的质量比例。</translation>
    </message>
    <message>
        <source>Spray</source>
        <translation>水花</translation>
    </message>
    <message>
        <source>Particles that are alone leave the flow and fly on as drops.</source>
        <translation>孤立的粒子离开流动，作为液滴继续飞行。</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>液滴</translation>
    </message>
    <message>
        <source>Diameter of the largest drops of spray; the air tears them to smaller ones where they are fast.</source>
        <translation>水花中最大液滴的直径；速度快时空气会将其撕碎。</translation>
    </message>
    <message>
        <source>Snow clumps</source>
        <translation>雪团</translation>
    </message>
    <message>
        <source>Diameter of the clumps of snow that fly on their own.</source>
        <translation>独自飞行的雪团的直径。</translation>
    </message>
    <message>
        <source>Life of spray</source>
        <translation>水花寿命</translation>
    </message>
    <message>
        <source>Spray rate</source>
        <translation>水花速率</translation>
    </message>
    <message>
        <source>Share of a particle at the surface of water that is thrown up a second where air is trapped, a crest breaks and energy is high.</source>
        <translation>在卷入空气、波峰破碎且能量高处，水面粒子每秒被抛起的比例。</translation>
    </message>
    <message>
        <source>Trapped air from</source>
        <translation>卷入空气下限</translation>
    </message>
    <message>
        <source>Mean speed at which neighbours come nearer from which air is trapped (Ihmsen et al. 2012).</source>
        <translation>邻近粒子平均接近速度达到此值时开始卷入空气（Ihmsen 等，2012）。</translation>
    </message>
    <message>
        <source>Trapped air up to</source>
        <translation>卷入空气上限</translation>
    </message>
    <message>
        <source>The same, beyond which no more is thrown up.</source>
        <translation>同上，超过此值抛起量不再增加。</translation>
    </message>
    <message>
        <source>Crests from</source>
        <translation>波峰下限</translation>
    </message>
    <message>
        <source>Bend of the surface from which a wave&apos;s crest breaks (Ihmsen et al. 2012): mean of 1 - cosine of the angle between normals.</source>
        <translation>波峰开始破碎的表面弯曲度（Ihmsen 等，2012）：法线夹角的 1 - 余弦的平均值。</translation>
    </message>
    <message>
        <source>Crests up to</source>
        <translation>波峰上限</translation>
    </message>
    <message>
        <source>Energy from</source>
        <translation>能量下限</translation>
    </message>
    <message>
        <source>Kinetic energy per kilogram from which water is thrown up (Ihmsen et al. 2012).</source>
        <translation>水开始被抛起的每千克动能（Ihmsen 等，2012）。</translation>
    </message>
    <message>
        <source>Energy up to</source>
        <translation>能量上限</translation>
    </message>
    <message>
        <source>Most spray</source>
        <translation>水花上限</translation>
    </message>
    <message>
        <source>Parcels of spray at most; beyond, what is alone stays in the flow and nothing is thrown up.</source>
        <translation>水花包的最大数量；超过后孤立粒子留在流动中，不再抛起。</translation>
    </message>
    <message>
        <source>Mist and powder</source>
        <translation>水雾与粉雪</translation>
    </message>
    <message>
        <source>What hangs in the air over water and avalanches, and how it is computed.</source>
        <translation>水流与雪崩上方悬浮于空气中的东西及其计算方式。</translation>
    </message>
    <message>
        <source>Pause mist and powder</source>
        <translation>暂停水雾与粉雪</translation>
    </message>
    <message>
        <source>While it is on, mist, powder and spray stand still and everything else goes on.</source>
        <translation>开启时水雾、粉雪和水花静止，其余一切继续。</translation>
    </message>
    <message>
        <source>Speed against the air from which the surface of water frays and impacts throw up mist; all of it at three times that speed.</source>
        <translation>水面开始破碎、撞击开始扬起水雾的相对空气速度；达到其三倍时全部生效。</translation>
    </message>
    <message>
        <source>Speed against the air from which the surface of snow is whirled up and impacts throw up powder; all of it at three times that speed.</source>
        <translation>雪面开始扬起、撞击开始扬起粉雪的相对空气速度；达到其三倍时全部生效。</translation>
    </message>
    <message>
        <source>Small eddies</source>
        <translation>小涡旋</translation>
    </message>
    <message>
        <source>Mixing by eddies that are smaller than a cell, by how fast the air shears: Smagorinsky&apos;s constant, 0.1 to 0.2; 0 leaves it out.</source>
        <translation>小于单元的涡旋按空气剪切快慢引起的混合：Smagorinsky 常数，0.1 至 0.2；0 表示不计。</translation>
    </message>
    <message>
        <source>The same mixing everywhere, whatever the air does.</source>
        <translation>无论空气如何运动，各处相同的混合。</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>水团</translation>
    </message>
    <message>
        <source>Diameter of the lumps of water that leave the flow, if that is less than its spacing; the air tears them to drops.</source>
        <translation>离开水流的水团的直径（小于粒子间距时）；空气把它们撕成液滴。</translation>
    </message>
    <message>
        <source>Time in which flying drops fray into mist, to 37 %; larger ones take longer.</source>
        <translation>飞行的液滴散成水雾、仅余 37 % 所需的时间；大的更久。</translation>
    </message>
    <message>
        <source>Life of clumps</source>
        <translation>雪团寿命</translation>
    </message>
    <message>
        <source>Time in which flying clumps of snow fray into powder, to 37 %.</source>
        <translation>飞行的雪团散成粉雪、仅余 37 % 所需的时间。</translation>
    </message>
</context>
<context>
    <name>SceneChecks</name>
    <message>
        <source>Camera and target stand on the same spot. Move one of them.</source>
        <translation>摄像机与目标位于同一点。请移动其中一个。</translation>
    </message>
    <message>
        <source>There is no camera: pictures use a default view. Add a camera.</source>
        <translation>没有摄像机：图像使用默认视图。请添加摄像机。</translation>
    </message>
    <message>
        <source>It snows without weather: default weather is used. Add weather.</source>
        <translation>降雪但没有天气：使用默认天气。请添加天气。</translation>
    </message>
    <message>
        <source>The last frame comes before the first one.</source>
        <translation>最后一帧在第一帧之前。</translation>
    </message>
    <message>
        <source>Slopes must shed their snow at a steeper angle than they hold it.</source>
        <translation>坡面脱落积雪的角度必须大于保持积雪的角度。</translation>
    </message>
    <message>
        <source>Samples per pixel should be 1, 2, 4 or 8.</source>
        <translation>每像素采样数应为 1、2、4 或 8。</translation>
    </message>
    <message>
        <source>The file %1 lies outside the scene&apos;s folder: the command line refuses it, and it is missing where the scene is moved to. Use File &gt; Collect files beside the scene.</source>
        <translation>文件 %1 位于场景文件夹之外：命令行会拒绝它，场景移到别处后也会找不到它。请使用“文件 &gt; 将文件收集到场景旁”。</translation>
    </message>
    <message>
        <source>No file is chosen for %1.</source>
        <translation>没有为 %1 选择文件。</translation>
    </message>
    <message>
        <source>The film&apos;s begin is no date. Write it as 2005-10-01 00:00 (UTC).</source>
        <translation>影片开始不是日期。请写成 2005-10-01 00:00（UTC）。</translation>
    </message>
    <message>
        <source>The sun needs a date: it stands still until the film&apos;s begin is set.</source>
        <translation>太阳需要日期：设定影片开始之前它静止不动。</translation>
    </message>
    <message>
        <source>What flows passes through models. To put %1 in its way, select it and press &quot;Make rigid body&quot; at the end of its properties.</source>
        <translation>流体会穿过模型。要让 %1 挡住它，请选中它并按其属性末尾的“设为刚体”。</translation>
    </message>
    <message>
        <source>The ground round all %1 copies of %2 has small cover cells, which takes much time and memory. Switch that off for what stands in great numbers.</source>
        <translation>%2 的全部 %1 个副本周围的地面都使用小积雪单元，会耗费大量时间和内存。数量众多的物体请关闭此项。</translation>
    </message>
    <message>
        <source>Mist and powder come from what flows. Add a water source or an avalanche release.</source>
        <translation>水雾与粉雪来自流动的物质。请添加水源或雪崩释放区。</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>Sun in %1°, %2° high</source>
        <translation>太阳方位 %1°，高度 %2°</translation>
    </message>
    <message>
        <source>Wind %1 m/s from %2°</source>
        <translation>风速 %1 m/s，来自 %2°</translation>
    </message>
    <message>
        <source>N</source>
        <translation>北</translation>
    </message>
    <message>
        <source>Radius %1 m</source>
        <translation>半径 %1 m</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
</context>
<context>
    <name>spin::Application</name>
    <message>
        <source>Editor and simulator of winter scenes.</source>
        <translation>冬季场景的编辑与模拟。</translation>
    </message>
    <message>
        <source>Language of the window: en, cs or zh_CN.</source>
        <translation>窗口语言：en、cs 或 zh_CN。</translation>
    </message>
    <message>
        <source>Simulates, plays and exports the scene, writes how long the window stood still to FILE as JSON, and ends.</source>
        <translation>模拟、播放并导出场景，将窗口停顿时间以 JSON 写入 FILE，然后结束。</translation>
    </message>
    <message>
        <source>Writes a picture of the window to FILE once the scene is simulated, and ends.</source>
        <translation>场景模拟完成后将窗口图像写入 FILE，然后结束。</translation>
    </message>
    <message>
        <source>A scene to open, or terrains and models to import.</source>
        <translation>要打开的场景，或要导入的地形和模型。</translation>
    </message>
</context>
<context>
    <name>spin::Autosave</name>
    <message>
        <source>The folder for recovery copies cannot be used: %1</source>
        <translation>无法使用恢复副本文件夹：%1</translation>
    </message>
</context>
<context>
    <name>spin::BrushBar</name>
    <message>
        <source>What the brush paints; a selected painted node takes its place</source>
        <translation>画笔绘制的对象；选中的绘制节点优先</translation>
    </message>
    <message>
        <source>What the brush paints (Ctrl + click in the view picks it)</source>
        <translation>画笔绘制的值（在视图中 Ctrl + 单击可拾取）</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Smooth, also with Shift held</source>
        <translation>平滑，也可按住 Shift</translation>
    </message>
    <message>
        <source>Erase to not painted</source>
        <translation>擦除为未绘制</translation>
    </message>
    <message>
        <source>Pick a value, also with Ctrl held</source>
        <translation>拾取数值，也可按住 Ctrl</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)</source>
        <translation>画笔半径（F 并移动指针；[ 和 ]；Ctrl + 滚轮）</translation>
    </message>
    <message>
        <source>Strength </source>
        <translation>强度 </translation>
    </message>
    <message>
        <source>How far a stroke goes towards the value (Shift+F and move the pointer)</source>
        <translation>一笔向目标值靠近的程度（Shift+F 并移动指针）</translation>
    </message>
    <message>
        <source>Hardness </source>
        <translation>硬度 </translation>
    </message>
    <message>
        <source>Share of the radius that has the full strength: the inner ring</source>
        <translation>具有全部强度的半径份额：内圈</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>笔</translation>
    </message>
    <message>
        <source>What the pressure of a pen changes</source>
        <translation>笔的压力改变什么</translation>
    </message>
    <message>
        <source>Pressure changes the strength</source>
        <translation>压力改变强度</translation>
    </message>
    <message>
        <source>A light touch paints little</source>
        <translation>轻触时着色较弱</translation>
    </message>
    <message>
        <source>Pressure changes the radius</source>
        <translation>压力改变半径</translation>
    </message>
    <message>
        <source>A light touch paints narrow</source>
        <translation>轻触时笔触较窄</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>What is done to the whole layer: fill, filters, files</source>
        <translation>对整个图层的操作：填充、滤镜、文件</translation>
    </message>
    <message>
        <source>&amp;Fill...</source>
        <translation>填充(&amp;F)...</translation>
    </message>
    <message>
        <source>Fill by altitude, slope and aspect</source>
        <translation>按海拔、坡度和坡向填充</translation>
    </message>
    <message>
        <source>F&amp;ilter...</source>
        <translation>滤镜(&amp;I)...</translation>
    </message>
    <message>
        <source>Blur, grow, shrink and more</source>
        <translation>模糊、扩张、收缩等</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>清除(&amp;C)</translation>
    </message>
    <message>
        <source>Take away all that is painted</source>
        <translation>移除所有绘制内容</translation>
    </message>
    <message>
        <source>I&amp;mport...</source>
        <translation>导入(&amp;M)...</translation>
    </message>
    <message>
        <source>Take the layer from a picture or a GeoTIFF</source>
        <translation>从图像或 GeoTIFF 获取图层</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>导出(&amp;E)...</translation>
    </message>
    <message>
        <source>Write the layer as a picture or a GeoTIFF</source>
        <translation>将图层写为图像或 GeoTIFF</translation>
    </message>
</context>
<context>
    <name>spin::ExportDialog</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 分 %2 秒</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 小时 %2 分</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>What to write</source>
        <translation>写出内容</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Picture size</source>
        <translation>图像尺寸</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>选择...</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>估计</translation>
    </message>
    <message>
        <source>The same export on the command line</source>
        <translation>命令行中的相同导出</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Folder for the export</source>
        <translation>导出文件夹</translation>
    </message>
    <message>
        <source>Choose at least one thing to write.</source>
        <translation>请至少选择一项写出内容。</translation>
    </message>
    <message>
        <source>The last frame lies before the first.</source>
        <translation>最后一帧在第一帧之前。</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>请选择文件夹。</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s), about %1 on disk</source>
        <translation>
            <numerusform>%n 帧，磁盘上约 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Starting...</source>
        <translation>正在启动...</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>%p %, %1 left</source>
        <translation>%p %，剩余 %1</translation>
    </message>
    <message>
        <source>Written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;.</source>
        <translation>已写入 &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;。</translation>
    </message>
    <message>
        <source>Stopped. Files written so far stay in the folder.</source>
        <translation>已停止。已写出的文件保留在文件夹中。</translation>
    </message>
    <message>
        <source>The export failed.</source>
        <translation>导出失败。</translation>
    </message>
    <message>
        <source>The export is still running.</source>
        <translation>导出仍在进行。</translation>
    </message>
    <message>
        <source>Stop it</source>
        <translation>停止导出</translation>
    </message>
    <message>
        <source>Keep exporting</source>
        <translation>继续导出</translation>
    </message>
    <message>
        <source>Exported to %1.</source>
        <translation>已导出到 %1。</translation>
    </message>
    <message>
        <source>%1 days</source>
        <translation>%1 天</translation>
    </message>
    <message>
        <source>%1 years</source>
        <translation>%1 年</translation>
    </message>
</context>
<context>
    <name>spin::ExportJob</name>
    <message>
        <source>The export program ended unexpectedly.</source>
        <translation>导出程序意外结束。</translation>
    </message>
    <message>
        <source>The export program could not be started: %1</source>
        <translation>无法启动导出程序：%1</translation>
    </message>
</context>
<context>
    <name>spin::FileFlow</name>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has changes that are not saved.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>打开场景</translation>
    </message>
    <message>
        <source>Spindrift scenes (*.spindrift)</source>
        <translation>Spindrift 场景 (*.spindrift)</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>保存场景</translation>
    </message>
    <message>
        <source>Spindrift</source>
        <translation>Spindrift</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scene</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>磁盘上的文件已更改</translation>
    </message>
    <message>
        <source>Another program has changed &quot;%1&quot; since it was opened or saved here. Saving overwrites these changes.</source>
        <translation>“%1”在此处打开或保存之后已被其他程序更改。保存会覆盖这些更改。</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>另存为...</translation>
    </message>
</context>
<context>
    <name>spin::FillDialog</name>
    <message>
        <source>Fill: %1</source>
        <translation>填充：%1</translation>
    </message>
    <message>
        <source>What the layer is filled with</source>
        <translation>填充图层的值</translation>
    </message>
    <message>
        <source>How the value joins what is painted there</source>
        <translation>该值与已绘制内容的组合方式</translation>
    </message>
    <message>
        <source>Replaces what is there</source>
        <translation>替换已有内容</translation>
    </message>
    <message>
        <source>The larger of both</source>
        <translation>取较大者</translation>
    </message>
    <message>
        <source>Is added</source>
        <translation>相加</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Combine</source>
        <translation>组合方式</translation>
    </message>
    <message>
        <source>Altitude</source>
        <translation>海拔</translation>
    </message>
    <message>
        <source>Height above sea</source>
        <translation>海拔高度</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>坡度</translation>
    </message>
    <message>
        <source>Steepness from level ground</source>
        <translation>相对水平面的陡度</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>坡向</translation>
    </message>
    <message>
        <source>The way the ground faces, clockwise: 0 north, 90 east</source>
        <translation>地面朝向，顺时针：0 为北，90 为东</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>填充</translation>
    </message>
    <message>
        <source>Fill as the view shows it; one undo step</source>
        <translation>按视图所示填充；一步撤销</translation>
    </message>
    <message>
        <source>Where the range begins</source>
        <translation>范围的起点</translation>
    </message>
    <message>
        <source>Where the range ends</source>
        <translation>范围的终点</translation>
    </message>
    <message>
        <source>Width of the soft edge on either side</source>
        <translation>两侧柔和边缘的宽度</translation>
    </message>
    <message>
        <source>to</source>
        <translation>至</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>柔和边缘</translation>
    </message>
    <message>
        <source>A quarter of the horizon by name</source>
        <translation>按名称选择四分之一方位</translation>
    </message>
    <message>
        <source>North</source>
        <translation>北</translation>
    </message>
    <message>
        <source>North-east</source>
        <translation>东北</translation>
    </message>
    <message>
        <source>East</source>
        <translation>东</translation>
    </message>
    <message>
        <source>South-east</source>
        <translation>东南</translation>
    </message>
    <message>
        <source>South</source>
        <translation>南</translation>
    </message>
    <message>
        <source>South-west</source>
        <translation>西南</translation>
    </message>
    <message>
        <source>West</source>
        <translation>西</translation>
    </message>
    <message>
        <source>North-west</source>
        <translation>西北</translation>
    </message>
    <message>
        <source>Own range</source>
        <translation>自定义范围</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Fills %1 % of the terrain, %2.</source>
        <translation>填充地形的 %1 %，%2。</translation>
    </message>
    <message>
        <source>%1 km²</source>
        <translation>%1 km²</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
</context>
<context>
    <name>spin::FilterDialog</name>
    <message>
        <source>Filter: %1</source>
        <translation>滤镜：%1</translation>
    </message>
    <message>
        <source>What the filter does</source>
        <translation>滤镜的作用</translation>
    </message>
    <message>
        <source>How far the filter reaches</source>
        <translation>滤镜的作用范围</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>What is less is taken away</source>
        <translation>小于此值的被移除</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>滤镜</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Filter as the view shows it; one undo step</source>
        <translation>按视图所示应用滤镜；一步撤销</translation>
    </message>
</context>
<context>
    <name>spin::FlakePanel</name>
    <message>
        <source>radius %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
    <message numerus="yes">
        <source>%n cell(s) of ice</source>
        <translation>
            <numerusform>%n 个冰格</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n particle(s)</source>
        <translation>
            <numerusform>%n 个粒子</numerusform>
        </translation>
    </message>
    <message>
        <source>D = %1</source>
        <translation>D = %1</translation>
    </message>
    <message>
        <source>Apply flake</source>
        <translation>应用雪花</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>生长</translation>
    </message>
    <message>
        <source>Stop the growth; what has grown stays</source>
        <translation>停止生长;已生长的保留</translation>
    </message>
    <message>
        <source>Grow a flake with these settings and watch it</source>
        <translation>用这些设置生长一片雪花并观看</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>另一片</translation>
    </message>
    <message>
        <source>Grow another flake of the same kind: the next seed</source>
        <translation>生长同类的另一片雪花:下一个种子</translation>
    </message>
    <message>
        <source>Apply to scene</source>
        <translation>应用到场景</translation>
    </message>
    <message>
        <source>Let the scene&apos;s flakes grow like this one</source>
        <translation>让场景的雪花像这片一样生长</translation>
    </message>
    <message>
        <source>The flake as it grows</source>
        <translation>生长中的雪花</translation>
    </message>
    <message>
        <source>Size of the flake and its fractal dimension by the radius of gyration</source>
        <translation>雪花的大小及其按回转半径的分形维数</translation>
    </message>
    <message>
        <source>Nothing has grown yet</source>
        <translation>尚未生长</translation>
    </message>
</context>
<context>
    <name>spin::ImportDialog</name>
    <message>
        <source>Import terrain</source>
        <translation>导入地形</translation>
    </message>
    <message>
        <source>Import model</source>
        <translation>导入模型</translation>
    </message>
    <message>
        <source>Reading...</source>
        <translation>正在读取...</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>Reads the file with the options above</source>
        <translation>用上面的选项读取文件</translation>
    </message>
    <message>
        <source>From the file</source>
        <translation>取自文件</translation>
    </message>
    <message>
        <source>EPSG code</source>
        <translation>EPSG 代码</translation>
    </message>
    <message>
        <source> m</source>
        <translation> 米</translation>
    </message>
    <message>
        <source>From the file, or 1 m</source>
        <translation>取自文件，否则 1 米</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>网格大小</translation>
    </message>
    <message>
        <source>Height unit</source>
        <translation>高度单位</translation>
    </message>
    <message>
        <source>Cells with this value are holes:</source>
        <translation>具有此值的网格为空洞：</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>按文件所述</translation>
    </message>
    <message>
        <source>Y is up</source>
        <translation>Y 轴朝上</translation>
    </message>
    <message>
        <source>Z is up</source>
        <translation>Z 轴朝上</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>朝上的轴</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>文件单位</translation>
    </message>
    <message>
        <source>Copy beside the scene</source>
        <translation>复制到场景旁</translation>
    </message>
    <message>
        <source>Copies the file and what it refers to into the scene&apos;s folder, so that the scene can be moved. A scene without a folder gets the copy when it is saved.</source>
        <translation>将文件及其引用的内容复制到场景的文件夹中，这样场景可以移动。尚无文件夹的场景在保存时得到副本。</translation>
    </message>
</context>
<context>
    <name>spin::ImportFlow</name>
    <message>
        <source>Import terrain or model</source>
        <translation>导入地形或模型</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a terrain nor a model this program reads.</source>
        <translation>“%1”不是本程序可读取的地形或模型。</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Import terrain</source>
        <translation>导入地形</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Its coordinates, credit line, name and import options go with it.</source>
        <translation>其坐标、数据来源、名称和导入选项将一并被替换。</translation>
    </message>
    <message>
        <source>What is painted on it (%1) is kept cell by cell if the new terrain has as many columns and rows. Otherwise it is left out, and the list of issues says so.</source>
        <translation>如果新地形的列数和行数相同，其上绘制的内容（%1）将逐格保留；否则不予使用，并在问题列表中说明。</translation>
    </message>
    <message>
        <source>Replace the terrain &quot;%1&quot;?</source>
        <translation>要替换地形“%1”吗？</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not imported: another scene was opened meanwhile.</source>
        <translation>“%1”未导入：期间打开了另一个场景。</translation>
    </message>
    <message>
        <source>Copied to &quot;%1&quot;.</source>
        <translation>已复制到“%1”。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; will be copied beside the scene when it is saved.</source>
        <translation>保存场景时会将“%1”复制到场景旁。</translation>
    </message>
    <message>
        <source>The file stays where it is; scenes may use the folder &quot;%1&quot; from now on.</source>
        <translation>文件保留在原处；此后场景可以使用文件夹“%1”。</translation>
    </message>
    <message>
        <source>All files lie in the scene&apos;s folder already; nothing was copied.</source>
        <translation>所有文件都已在场景的文件夹中；没有复制任何文件。</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) copied to &quot;%1&quot;. Save the scene to use them from there.</source>
        <translation>
            <numerusform>已将 %n 个文件复制到“%1”。请保存场景，以便从那里使用它们。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spin::ImportJob</name>
    <message>
        <source>Terrain and models</source>
        <translation>地形和模型</translation>
    </message>
    <message>
        <source>Elevation models</source>
        <translation>高程模型</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>模型</translation>
    </message>
</context>
<context>
    <name>spin::IssueModel</name>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>Issue</source>
        <translation>问题</translation>
    </message>
</context>
<context>
    <name>spin::IssuesPanel</name>
    <message>
        <source>No issues</source>
        <translation>没有问题</translation>
    </message>
</context>
<context>
    <name>spin::LayerFileDialog</name>
    <message>
        <source>Export: %1</source>
        <translation>导出：%1</translation>
    </message>
    <message>
        <source>Import: %1</source>
        <translation>导入：%1</translation>
    </message>
    <message>
        <source>GeoTIFF keeps the values and where nothing is painted; a PNG is a grey picture</source>
        <translation>GeoTIFF 保留数值和未绘制处；PNG 为灰度图像</translation>
    </message>
    <message>
        <source>GeoTIFF</source>
        <translation>GeoTIFF</translation>
    </message>
    <message>
        <source>PNG, 8 bit</source>
        <translation>PNG，8 位</translation>
    </message>
    <message>
        <source>PNG, 16 bit</source>
        <translation>PNG，16 位</translation>
    </message>
    <message>
        <source>What black stands for</source>
        <translation>黑色代表的值</translation>
    </message>
    <message>
        <source>What white stands for</source>
        <translation>白色代表的值</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黑色</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白色</translation>
    </message>
    <message>
        <source>Choose file...</source>
        <translation>选择文件...</translation>
    </message>
    <message>
        <source>Choose where to write</source>
        <translation>选择写入位置</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Take the file as the view shows it; one undo step</source>
        <translation>按视图所示采用文件；一步撤销</translation>
    </message>
    <message>
        <source>What is not painted becomes black.</source>
        <translation>未绘制处变为黑色。</translation>
    </message>
    <message>
        <source>%1 x %2 cells</source>
        <translation>%1 x %2 格</translation>
    </message>
    <message>
        <source>real numbers</source>
        <translation>实数</translation>
    </message>
    <message>
        <source>%1 bit</source>
        <translation>%1 位</translation>
    </message>
    <message>
        <source>with its place in the world</source>
        <translation>带有地理位置</translation>
    </message>
    <message>
        <source>laid over the whole terrain</source>
        <translation>铺满整个地形</translation>
    </message>
</context>
<context>
    <name>spin::LayerTools</name>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>The painted layers are still being read.</source>
        <translation>绘制的图层仍在读取。</translation>
    </message>
    <message>
        <source>There is no terrain to paint on: import one first.</source>
        <translation>没有可绘制的地形：请先导入。</translation>
    </message>
    <message>
        <source>Fill %1</source>
        <translation>填充%1</translation>
    </message>
    <message>
        <source>Filters work on temperature, depth and keep-clear layers; for ground types there is the smoothing brush.</source>
        <translation>滤镜用于温度、雪深和保持无雪图层；地面类型请使用平滑画笔。</translation>
    </message>
    <message>
        <source>No plugin with filters is installed.</source>
        <translation>未安装带滤镜的插件。</translation>
    </message>
    <message>
        <source>Filter %1</source>
        <translation>滤镜处理%1</translation>
    </message>
    <message>
        <source>Import a layer</source>
        <translation>导入图层</translation>
    </message>
    <message>
        <source>Rasters (*.png *.tif *.tiff *.asc *.xyz)</source>
        <translation>栅格 (*.png *.tif *.tiff *.asc *.xyz)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入%1</translation>
    </message>
    <message>
        <source>Export a layer</source>
        <translation>导出图层</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>清除%1</translation>
    </message>
    <message>
        <source>The last change of a layer is still being worked out.</source>
        <translation>图层的上一次更改仍在计算。</translation>
    </message>
</context>
<context>
    <name>spin::MainActions</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open...</source>
        <translation>打开(&amp;O)...</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近打开(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;as...</source>
        <translation>另存为(&amp;A)...</translation>
    </message>
    <message>
        <source>&amp;Collect files beside the scene</source>
        <translation>将文件收集到场景旁(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Import terrain or model...</source>
        <translation>导入地形或模型(&amp;I)...</translation>
    </message>
    <message>
        <source>&amp;Export...</source>
        <translation>导出(&amp;E)...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>复制(&amp;D)</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;L)</translation>
    </message>
    <message>
        <source>Set &amp;keys</source>
        <translation>设置关键帧(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Add node</source>
        <translation>添加节点(&amp;A)</translation>
    </message>
    <message>
        <source>%1...</source>
        <translation>%1...</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Frame selection</source>
        <translation>聚焦所选(&amp;F)</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>显示全部(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Look through the camera</source>
        <translation>通过摄像机观看(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Set the camera from the view</source>
        <translation>按视图设置摄像机(&amp;S)</translation>
    </message>
    <message>
        <source>S&amp;now cover</source>
        <translation>积雪(&amp;N)</translation>
    </message>
    <message>
        <source>Fa&amp;lling flakes</source>
        <translation>飘落的雪花(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>重置布局(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Ground shows</source>
        <translation>地面显示(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Natural colours</source>
        <translation>自然颜色(&amp;N)</translation>
    </message>
    <message>
        <source>Ground &amp;types</source>
        <translation>地面类型(&amp;T)</translation>
    </message>
    <message>
        <source>Ground t&amp;emperature</source>
        <translation>地面温度(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>模拟(&amp;S)</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>停止(&amp;T)</translation>
    </message>
    <message>
        <source>Simulate &amp;after edits</source>
        <translation>编辑后自动模拟(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Delete out-of-date frames from disk</source>
        <translation>从磁盘删除过期帧(&amp;D)</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>播放或暂停</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>上一帧</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>下一帧</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最后一帧</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Local axes</source>
        <translation>局部坐标轴</translation>
    </message>
    <message>
        <source>Handles along the model&apos;s own axes (X)</source>
        <translation>手柄沿模型自身的坐标轴 (X)</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>缩小画笔</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>放大画笔</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keys and pointer</source>
        <translation>按键与鼠标(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;About Spindrift</source>
        <translation>关于 Spindrift(&amp;A)</translation>
    </message>
    <message>
        <source>Middle button, Alt + left</source>
        <translation>中键，Alt + 左键</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>旋转视图</translation>
    </message>
    <message>
        <source>Shift + middle button</source>
        <translation>Shift + 中键</translation>
    </message>
    <message>
        <source>Shift the view</source>
        <translation>平移视图</translation>
    </message>
    <message>
        <source>Wheel, Ctrl + middle button</source>
        <translation>滚轮，Ctrl + 中键</translation>
    </message>
    <message>
        <source>Nearer and farther</source>
        <translation>拉近和拉远</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>Ctrl while dragging a handle</source>
        <translation>拖动手柄时按 Ctrl</translation>
    </message>
    <message>
        <source>Whole steps: 1 m, 15 degrees, 0.1</source>
        <translation>整步：1 米、15 度、0.1</translation>
    </message>
    <message>
        <source>Escape while dragging</source>
        <translation>拖动时按 Escape</translation>
    </message>
    <message>
        <source>Take the drag back</source>
        <translation>取消拖动</translation>
    </message>
    <message>
        <source>Keys and pointer</source>
        <translation>按键与鼠标</translation>
    </message>
    <message>
        <source>About Spindrift</source>
        <translation>关于 Spindrift</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Spindrift %1&lt;/h3&gt;&lt;p&gt;Editor and simulator of winter scenes.&lt;/p&gt;&lt;p&gt;Apache License 2.0. What it builds on is listed in the file NOTICE.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Spindrift %1&lt;/h3&gt;&lt;p&gt;冬季场景的编辑与模拟。&lt;/p&gt;&lt;p&gt;Apache 许可证 2.0。所用组件列于 NOTICE 文件。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Flo&amp;w shows</source>
        <translation>流动显示(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Boundary particles</source>
        <translation>边界粒子(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>暂停(&amp;P)</translation>
    </message>
    <message>
        <source>Hold the simulation; it goes on where it was</source>
        <translation>暂停模拟；之后从原处继续</translation>
    </message>
    <message>
        <source>S&amp;ingle step</source>
        <translation>单步(&amp;I)</translation>
    </message>
    <message>
        <source>Hold the simulation and compute one frame further</source>
        <translation>暂停模拟并再计算一帧</translation>
    </message>
    <message>
        <source>Pause s&amp;now from here</source>
        <translation>从此处暂停雪(&amp;N)</translation>
    </message>
    <message>
        <source>Snowfall and cover stand still from the shown frame on</source>
        <translation>从所示帧起降雪和积雪静止</translation>
    </message>
    <message>
        <source>Pause &amp;flow from here</source>
        <translation>从此处暂停流动(&amp;F)</translation>
    </message>
    <message>
        <source>Avalanches, water and bodies stand still from the shown frame on</source>
        <translation>从所示帧起雪崩、水和物体静止</translation>
    </message>
    <message>
        <source>Reset the simulation</source>
        <translation>重置模拟</translation>
    </message>
    <message>
        <source>All simulated frames of this scene are thrown away, in memory and on disk, and the simulation starts again at the first frame.</source>
        <translation>此场景所有已模拟的帧（内存和磁盘）都将丢弃，模拟从第一帧重新开始。</translation>
    </message>
    <message>
        <source>&amp;Reset...</source>
        <translation>重置(&amp;R)...</translation>
    </message>
    <message>
        <source>Throw away all simulated frames and start again</source>
        <translation>丢弃所有已模拟的帧并重新开始</translation>
    </message>
    <message>
        <source>Draw the outline of a release</source>
        <translation>绘制释放区轮廓</translation>
    </message>
    <message>
        <source>Up and down instead of along the ground</source>
        <translation>上下移动而不沿地面</translation>
    </message>
    <message>
        <source>Click with the outline tool</source>
        <translation>用轮廓工具单击</translation>
    </message>
    <message>
        <source>Add a corner; on a side, put one in</source>
        <translation>添加角点；在边上则插入</translation>
    </message>
    <message>
        <source>Delete over a corner</source>
        <translation>在角点上按 Delete</translation>
    </message>
    <message>
        <source>Take the corner out</source>
        <translation>移除角点</translation>
    </message>
    <message>
        <source>&amp;Painted layer</source>
        <translation>绘制图层(&amp;P)</translation>
    </message>
    <message>
        <source>Painted snow &amp;depth</source>
        <translation>绘制的雪深(&amp;D)</translation>
    </message>
    <message>
        <source>What is &amp;kept clear</source>
        <translation>保持无雪的区域(&amp;K)</translation>
    </message>
    <message>
        <source>The &amp;painted layer while painting</source>
        <translation>绘制时显示绘制图层(&amp;P)</translation>
    </message>
    <message>
        <source>Paint ground types, temperature, snow depth, what is kept clear, or the selected release</source>
        <translation>绘制地面类型、温度、雪深、保持无雪的区域，或所选的释放区</translation>
    </message>
    <message>
        <source>F, Shift + F with the brush</source>
        <translation>使用画笔时 F、Shift + F</translation>
    </message>
    <message>
        <source>Radius and strength by moving the pointer</source>
        <translation>移动指针调整半径和强度</translation>
    </message>
    <message>
        <source>Shift, Ctrl with the brush</source>
        <translation>使用画笔时 Shift、Ctrl</translation>
    </message>
    <message>
        <source>Smooth; pick the value under the pointer</source>
        <translation>平滑；拾取指针下的数值</translation>
    </message>
    <message>
        <source>&amp;Values under the pointer</source>
        <translation>指针处的数值(&amp;V)</translation>
    </message>
    <message>
        <source>A line at the lower left: depth, mass and temperature of the snow under the pointer, and the type of the ground.</source>
        <translation>左下角的一行:指针处积雪的深度、质量和温度,以及地面类型。</translation>
    </message>
    <message>
        <source>Snow s&amp;hows</source>
        <translation>雪显示(&amp;H)</translation>
    </message>
    <message>
        <source>Colours the snow cover by this value, here and in exported pictures; the range of colours is set at the picture settings.</source>
        <translation>按此数值为积雪着色,此处和导出的图片相同;颜色范围在图片设置中设定。</translation>
    </message>
    <message>
        <source>&amp;Published shading (Blinn-Phong)</source>
        <translation>发表的着色 (Blinn-Phong)(&amp;P)</translation>
    </message>
    <message>
        <source>Lights the snow by ambient, diffuse and mirrored light as published, instead of the physically based way.</source>
        <translation>按发表的方式以环境光、漫反射光和镜面光照亮雪,而非基于物理的方式。</translation>
    </message>
    <message>
        <source>&amp;Hints of the tools</source>
        <translation>工具提示(&amp;H)</translation>
    </message>
    <message>
        <source>Scatter copies of a model over the ground</source>
        <translation>在地面上散布模型副本</translation>
    </message>
    <message>
        <source>Shift while dragging a handle</source>
        <translation>拖动手柄时按住 Shift</translation>
    </message>
    <message>
        <source>Shift with copies</source>
        <translation>散布副本时按住 Shift</translation>
    </message>
    <message>
        <source>Take copies away</source>
        <translation>移除副本</translation>
    </message>
    <message>
        <source>Ctrl + click with copies</source>
        <translation>散布副本时按 Ctrl 单击</translation>
    </message>
    <message>
        <source>Choose the model that is copied</source>
        <translation>选择要复制的模型</translation>
    </message>
    <message>
        <source>The particles on the surface of rigid bodies that the flow pushes against; terrain has none</source>
        <translation>刚体表面上受流体推挤的粒子；地形没有边界粒子</translation>
    </message>
    <message>
        <source>&amp;Air shows</source>
        <translation>空气显示(&amp;A)</translation>
    </message>
    <message>
        <source>Colours mist and powder in the air by this value, here and in exported pictures; the range of colours is set at the picture settings.</source>
        <translation>按此数值为空气中的水雾和雪粉着色,此处和导出的图片相同;颜色范围在图片设置中设定。</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Shows the value on a plane across this axis instead of in the whole cloud; where the plane stands is set at the picture settings.</source>
        <translation>在垂直于此轴的平面上显示该数值,而不是在整个云团中显示;平面的位置在图片设置中设定。</translation>
    </message>
    <message>
        <source>Pause &amp;mist and powder from here</source>
        <translation>从此处暂停水雾与粉雪(&amp;M)</translation>
    </message>
    <message>
        <source>Mist, powder and spray stand still from the shown frame on</source>
        <translation>从显示的帧起水雾、粉雪和水花静止</translation>
    </message>
    <message>
        <source>Show a slice of the air</source>
        <translation>显示空气切片</translation>
    </message>
</context>
<context>
    <name>spin::MainWindow</name>
    <message>
        <source>Saved.</source>
        <translation>已保存。</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Issues</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>Drop an elevation model here</source>
        <translation>将高程模型拖放到此处</translation>
    </message>
    <message>
        <source>or use File &gt; Import. It snows on the first terrain of a scene; models (glTF, OBJ, PLY) are placed where the view looks.</source>
        <translation>或使用“文件 &gt; 导入”。场景的第一个地形上会立即下雪；模型（glTF、OBJ、PLY）放置在视图所看之处。</translation>
    </message>
    <message>
        <source>%1[*] - Spindrift</source>
        <translation>%1[*] - Spindrift</translation>
    </message>
    <message>
        <source>Unsaved work found</source>
        <translation>发现未保存的工作</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved. Its last changes were kept on %2.</source>
        <translation>“%1”未保存。其最后的更改保存于 %2。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>稍后</translation>
    </message>
    <message>
        <source>Save first</source>
        <translation>请先保存</translation>
    </message>
    <message>
        <source>Exports are made from the saved scene. Save it now?</source>
        <translation>导出使用已保存的场景。现在保存吗？</translation>
    </message>
    <message numerus="yes">
        <source>The recovered scene is open; %n file(s) of the command line were not opened.</source>
        <translation>
            <numerusform>已打开恢复的场景；命令行中的 %n 个文件未打开。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Flake</source>
        <translation>雪花</translation>
    </message>
</context>
<context>
    <name>spin::OutlinerPanel</name>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a node to the scene</source>
        <translation>向场景添加节点</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>The scene has one already</source>
        <translation>场景中已有一个</translation>
    </message>
</context>
<context>
    <name>spin::PathEditor</name>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
</context>
<context>
    <name>spin::PictureView</name>
    <message>
        <source>There is no screen here. Everything but the picture works.</source>
        <translation>此处没有屏幕。除画面外其他功能均可使用。</translation>
    </message>
    <message>
        <source>The scene cannot be drawn here. Everything else works.
%1</source>
        <translation>此处无法绘制场景。其他功能均可使用。
%1</translation>
    </message>
</context>
<context>
    <name>spin::PointsEditor</name>
    <message>
        <source>east north; east north; ...</source>
        <translation>东 北；东 北；...</translation>
    </message>
</context>
<context>
    <name>spin::PropertyPanel</name>
    <message>
        <source>Nothing is selected</source>
        <translation>未选择任何内容</translation>
    </message>
    <message>
        <source>Make rigid body</source>
        <translation>设为刚体</translation>
    </message>
    <message>
        <source>Make this model solid for avalanches and water, or show the body that does so</source>
        <translation>使此模型对雪崩和水成为固体，或显示已有的刚体</translation>
    </message>
</context>
<context>
    <name>spin::PropertyRowEditor</name>
    <message>
        <source>Back to the default</source>
        <translation>恢复默认值</translation>
    </message>
    <message>
        <source>Set a key: animate this property</source>
        <translation>设置关键帧：为此属性制作动画</translation>
    </message>
    <message>
        <source>Animated; set a key at this frame</source>
        <translation>已有动画；在此帧设置关键帧</translation>
    </message>
    <message>
        <source>Remove the key at this frame</source>
        <translation>删除此帧的关键帧</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
</context>
<context>
    <name>spin::ScatterBar</name>
    <message>
        <source>The model that is copied (Ctrl + click in the view chooses it)</source>
        <translation>要复制的模型（在视图中按 Ctrl 单击选择）</translation>
    </message>
    <message>
        <source>No model</source>
        <translation>无模型</translation>
    </message>
    <message>
        <source>Scatter copies</source>
        <translation>散布副本</translation>
    </message>
    <message>
        <source>Take copies away, also with Shift held</source>
        <translation>移除副本，也可按住 Shift</translation>
    </message>
    <message>
        <source> m</source>
        <translation> m</translation>
    </message>
    <message>
        <source>Radius of the brush (F and move the pointer; [ and ]; Ctrl + wheel)</source>
        <translation>画笔半径（F 并移动指针；[ 和 ]；Ctrl + 滚轮）</translation>
    </message>
    <message>
        <source> per 100 m²</source>
        <translation> 个/100 m²</translation>
    </message>
    <message>
        <source>How many copies stand on 100 m²; a stroke fills up to this</source>
        <translation>每 100 m² 的副本数；一笔补足到此数</translation>
    </message>
    <message>
        <source>Apart </source>
        <translation>间距 </translation>
    </message>
    <message>
        <source>Distance between copies at least</source>
        <translation>副本之间的最小距离</translation>
    </message>
    <message>
        <source>Turn </source>
        <translation>旋转 </translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Range within which all copies of the model are turned at random</source>
        <translation>模型所有副本随机旋转的范围</translation>
    </message>
    <message>
        <source>Size ±</source>
        <translation>大小 ±</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much larger or smaller all copies of the model are at random</source>
        <translation>模型所有副本随机放大或缩小的程度</translation>
    </message>
</context>
<context>
    <name>spin::SceneDocument</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>The scene has no file name yet.</source>
        <translation>场景还没有文件名。</translation>
    </message>
    <message>
        <source>The scene is being saved already.</source>
        <translation>场景正在保存。</translation>
    </message>
</context>
<context>
    <name>spin::SceneLock</name>
    <message>
        <source>This scene is open in another window of the program too. Whoever saves last overwrites what the other has saved.</source>
        <translation>此场景也在本程序的另一个窗口中打开。最后保存的一方会覆盖另一方保存的内容。</translation>
    </message>
</context>
<context>
    <name>spin::SceneTools</name>
    <message>
        <source>The painted layers are still being read.</source>
        <translation>绘制的图层仍在读取。</translation>
    </message>
    <message>
        <source>Paint ground</source>
        <translation>绘制地面</translation>
    </message>
    <message>
        <source>Set camera from view</source>
        <translation>按视图设置摄像机</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>摄像机</translation>
    </message>
    <message>
        <source>Select a node first: keys are set on its animated properties.</source>
        <translation>请先选择节点：关键帧设置在其动画属性上。</translation>
    </message>
    <message>
        <source>Nothing of this node is animated yet: use the key buttons beside its properties.</source>
        <translation>此节点尚无动画：请使用属性旁的关键帧按钮。</translation>
    </message>
    <message>
        <source>Set keys</source>
        <translation>设置关键帧</translation>
    </message>
    <message>
        <source>Draw release outline</source>
        <translation>绘制释放区轮廓</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Change pictures</source>
        <translation>更改图片设置</translation>
    </message>
    <message>
        <source>Pause process</source>
        <translation>暂停过程</translation>
    </message>
    <message>
        <source>Let process go on</source>
        <translation>让过程继续</translation>
    </message>
    <message>
        <source>Make rigid body</source>
        <translation>设为刚体</translation>
    </message>
</context>
<context>
    <name>spin::SimulationController</name>
    <message>
        <source>Simulation stopped.</source>
        <translation>模拟已停止。</translation>
    </message>
    <message>
        <source>Stale frames deleted.</source>
        <translation>过期帧已删除。</translation>
    </message>
    <message>
        <source>Simulation held; P goes on.</source>
        <translation>模拟已暂停；按 P 继续。</translation>
    </message>
</context>
<context>
    <name>spin::StagePanel</name>
    <message>
        <source>Frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>No frame is simulated yet</source>
        <translation>尚未模拟任何帧</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>All stages</source>
        <translation>所有阶段</translation>
    </message>
    <message>
        <source>Computed on</source>
        <translation>计算设备</translation>
    </message>
    <message>
        <source>Mass: %1</source>
        <translation>质量：%1</translation>
    </message>
    <message>
        <source>%1 kg</source>
        <translation>%1 kg</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>阶段</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>占比</translation>
    </message>
    <message>
        <source>Calls</source>
        <translation>调用</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy both tables as text</source>
        <translation>将两张表复制为文本</translation>
    </message>
</context>
<context>
    <name>spin::StatusPanel</name>
    <message>
        <source>%1 s per frame, %2 %3 %</source>
        <translation>每帧 %1 秒，%2 %3 %</translation>
    </message>
    <message>
        <source>Stop the simulation</source>
        <translation>停止模拟</translation>
    </message>
    <message>
        <source>Simulated frames in memory and on disk</source>
        <translation>内存和磁盘中的模拟帧</translation>
    </message>
    <message>
        <source>Time to draw the last picture of the view</source>
        <translation>绘制视图最近一幅图像的时间</translation>
    </message>
    <message>
        <source>What simulates: instruction set of the processor, or graphics card</source>
        <translation>模拟设备：处理器指令集或显卡</translation>
    </message>
    <message>
        <source>Reading files...</source>
        <translation>正在读取文件...</translation>
    </message>
    <message>
        <source>Simulating...</source>
        <translation>正在模拟...</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Frame %1 of %2, %3 left</source>
        <translation>第 %1 帧，共 %2 帧，剩余 %3</translation>
    </message>
    <message>
        <source>Cache %1</source>
        <translation>缓存 %1</translation>
    </message>
    <message>
        <source>Simulated frames: %1 in memory, %2 on disk, of these %3 out of date</source>
        <translation>模拟帧：内存 %1，磁盘 %2，其中过期 %3</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 毫秒</translation>
    </message>
    <message>
        <source>%1 particles</source>
        <translation>%1 个粒子</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>约 %1</translation>
    </message>
    <message>
        <source>%1 of memory</source>
        <translation>内存 %1</translation>
    </message>
    <message>
        <source>%1 on disk</source>
        <translation>磁盘 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s): %1</source>
        <translation>
            <numerusform>%n 帧：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>What the frames that are not simulated yet will take</source>
        <translation>尚未模拟的帧需要多少资源</translation>
    </message>
    <message>
        <source>How far one sees through the falling snow: there a dark object keeps 2 % of its contrast</source>
        <translation>透过降雪能看到的距离:那里深色物体保留 2 % 的对比度</translation>
    </message>
    <message>
        <source>Growing the shapes of the flakes; a click stops it</source>
        <translation>正在生长雪花形状;点击停止</translation>
    </message>
    <message>
        <source>Growing flakes %1 %</source>
        <translation>正在生长雪花 %1 %</translation>
    </message>
    <message>
        <source>Sight %1 km</source>
        <translation>能见度 %1 km</translation>
    </message>
    <message>
        <source>Sight %1 m</source>
        <translation>能见度 %1 m</translation>
    </message>
</context>
<context>
    <name>spin::TimelineBar</name>
    <message>
        <source>Frame %1: simulated</source>
        <translation>第 %1 帧：已模拟</translation>
    </message>
    <message>
        <source>Frame %1: from before the last change</source>
        <translation>第 %1 帧：上次更改之前的结果</translation>
    </message>
    <message>
        <source>Frame %1: not simulated yet</source>
        <translation>第 %1 帧：尚未模拟</translation>
    </message>
</context>
<context>
    <name>spin::TimelinePanel</name>
    <message>
        <source>%1 s</source>
        <translation>%1 秒</translation>
    </message>
    <message>
        <source>First frame (Home)</source>
        <translation>第一帧 (Home)</translation>
    </message>
    <message>
        <source>Previous frame (Left)</source>
        <translation>上一帧（左箭头）</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格）</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格）</translation>
    </message>
    <message>
        <source>Next frame (Right)</source>
        <translation>下一帧（右箭头）</translation>
    </message>
    <message>
        <source>Last frame (End)</source>
        <translation>最后一帧 (End)</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>当前帧</translation>
    </message>
</context>
<context>
    <name>spin::Viewport</name>
    <message>
        <source>Camera view</source>
        <translation>摄像机视图</translation>
    </message>
    <message>
        <source>Radius %1 m</source>
        <translation>半径 %1 m</translation>
    </message>
    <message>
        <source>Strength %1 %</source>
        <translation>强度 %1 %</translation>
    </message>
    <message>
        <source>Nothing is painted here</source>
        <translation>此处未绘制</translation>
    </message>
    <message>
        <source>There is no terrain to paint on: import one first</source>
        <translation>没有可绘制的地形：请先导入</translation>
    </message>
    <message>
        <source>Drag to paint. F: radius, Shift + F: strength, Shift: smooth, Ctrl: pick, D: erase</source>
        <translation>拖动以绘制。F：半径，Shift + F：强度，Shift：平滑，Ctrl：拾取，D：擦除</translation>
    </message>
    <message>
        <source>There is no terrain to scatter on: import one first</source>
        <translation>没有可散布的地形：请先导入</translation>
    </message>
    <message>
        <source>There is no model to copy: import one first</source>
        <translation>没有可复制的模型：请先导入</translation>
    </message>
    <message>
        <source>Drag to scatter copies, click for a single one. F: radius, Shift: take away, Ctrl: choose the model</source>
        <translation>拖动以散布副本，单击放置一个。F：半径，Shift：移除，Ctrl：选择模型</translation>
    </message>
    <message>
        <source>There is no terrain to draw on: import one first</source>
        <translation>没有可绘制的地形：请先导入</translation>
    </message>
    <message>
        <source>Click to add corners, drag to move them, Delete takes out the one under the pointer</source>
        <translation>单击添加角点，拖动以移动，Delete 移除指针下的角点</translation>
    </message>
    <message>
        <source>Click on the ground to begin the outline of a new avalanche release</source>
        <translation>单击地面以开始绘制新的雪崩释放区轮廓</translation>
    </message>
    <message>
        <source>Drag a handle. Ctrl: whole steps, Shift: up and down, Escape: take it back</source>
        <translation>拖动手柄。Ctrl：整步，Shift：上下，Escape：撤回</translation>
    </message>
    <message>
        <source>Select something that stands in the scene to get its handles</source>
        <translation>选择场景中的物体以显示其手柄</translation>
    </message>
    <message>
        <source>Click to select. Middle button or Alt: turn, with Shift: shift the view, wheel: nearer</source>
        <translation>单击选择。中键或 Alt：旋转，加 Shift：平移视图，滚轮：拉近</translation>
    </message>
    <message>
        <source>Click on the model to copy</source>
        <translation>单击要复制的模型</translation>
    </message>
    <message>
        <source>Copies: %1</source>
        <translation>副本：%1</translation>
    </message>
    <message>
        <source>Copies: %1, no more are possible</source>
        <translation>副本：%1，不能再多</translation>
    </message>
    <message>
        <source>Drag a handle. Ctrl: whole steps, Escape: take it back</source>
        <translation>拖动手柄。Ctrl：整步，Escape：撤回</translation>
    </message>
    <message>
        <source>W: move, E: turn, R: scale, S: scatter copies of the selected model</source>
        <translation>W：移动，E：旋转，R：缩放，S：散布所选模型的副本</translation>
    </message>
    <message>
        <source>B: paint the selected layer; the right button in the list of nodes fills and imports it</source>
        <translation>B：绘制所选图层；在节点列表中按右键可填充和导入</translation>
    </message>
    <message>
        <source>Drag a corner or the middle. O: add and delete corners, B: paint the release</source>
        <translation>拖动角点或中心。O：添加和删除角点，B：绘制释放区</translation>
    </message>
</context>
</TS>
