#include "panel_text.h"

#include <algorithm>
#include <string_view>

namespace lds::emulator {

namespace {

struct Entry {
    std::string_view english;
    const char* japanese;
    const char* chinese;
};

constexpr Entry entries[] = {
    // The menu (§2.2), by the catalog's names.
    {"Bank", "バンク", "存储库"},
    {"Sensing", "センシング", "感测"},
    {"Judgment", "判定", "判定"},
    {"Output", "出力", "输出"},
    {"Input", "入力", "输入"},
    {"Alarm", "アラーム", "报警"},
    {"Ethernet", "Ethernet", "Ethernet"},
    {"RS-485", "RS-485", "RS-485"},
    {"System", "システム", "系统"},
    {"Sampling Frequency", "サンプリング周期", "采样周期"},
    {"Average Times", "平均回数", "平均次数"},
    {"Brightness Tuning", "明るさチューニング", "亮度调谐"},
    {"Hold Mode", "ホールドモード", "保持模式"},
    {"±Inversion", "±反転", "±反转"},
    {"Span", "スパン", "量程"},
    {"Offset", "オフセット", "偏移"},
    {"HIGH Set Value", "HIGH設定値", "HIGH设定值"},
    {"LOW Set Value", "LOW設定値", "LOW设定值"},
    {"Hysteresis", "ヒステリシス", "迟滞"},
    {"Teaching Mode", "ティーチング種別", "示教类型"},
    {"Tolerance", "公差", "公差"},
    {"Output Delay Timer", "出力遅延タイマ", "输出延迟定时器"},
    {"Timer Select", "タイマ選択", "定时器选择"},
    {"Timer Setting", "タイマ設定", "定时器设定"},
    {"Laser Stop", "レーザ停止", "激光停止"},
    {"Trigger Mode", "トリガモード", "触发模式"},
    {"Alarm Digital Output", "アラーム時出力", "报警时输出"},
    {"Alarm Delay Count", "アラーム遅延回数", "报警延迟次数"},
    {"IP Address", "IPアドレス", "IP地址"},
    {"Subnet Mask", "サブネットマスク", "子网掩码"},
    {"Default Gateway", "ゲートウェイ", "默认网关"},
    {"Port No.(Tool)", "ポートNo.(ツール)", "端口号(工具)"},
    {"Port No.(Modbus)", "ポートNo.(Modbus)", "端口号(Modbus)"},
    {"Port No.(SLMP)", "ポートNo.(SLMP)", "端口号(SLMP)"},
    {"Network No./Node No.", "ネットワークNo./局番", "网络号/站号"},
    {"MAC Address", "MACアドレス", "MAC地址"},
    {"Termination Resistance", "終端抵抗", "终端电阻"},
    {"Device Address", "機器アドレス", "设备地址"},
    {"Comm Speed(bps)", "通信速度(bps)", "通信速度(bps)"},
    {"Parity/Stop Bit", "パリティ/ストップ", "校验/停止位"},
    {"Display Digit", "表示桁", "显示位数"},
    {"ECO Mode", "ECOモード", "ECO模式"},
    {"Display Inversion", "表示反転", "显示反转"},
    {"Language", "言語", "语言"},
    {"Comm Reset", "通信リセット", "通信复位"},
    {"Initialize", "初期化", "初始化"},
    // Choices.
    {"Bank 1", "バンク1", "存储库1"},
    {"Bank 2", "バンク2", "存储库2"},
    {"Bank 3", "バンク3", "存储库3"},
    {"Bank 4", "バンク4", "存储库4"},
    {"All Banks", "全バンク", "全部存储库"},
    {"All Areas", "全領域", "全部区域"},
    {"OFF", "OFF", "OFF"},
    {"ON", "ON", "ON"},
    {"1 time", "1回", "1次"},
    {"4 times", "4回", "4次"},
    {"16 times", "16回", "16次"},
    {"64 times", "64回", "64次"},
    {"256 times", "256回", "256次"},
    {"512 times", "512回", "512次"},
    {"1024 times", "1024回", "1024次"},
    {"None (Normal mode)", "なし(通常)", "无(通常)"},
    {"Peak Hold", "ピークホールド", "峰值保持"},
    {"Bottom Hold", "ボトムホールド", "谷值保持"},
    {"Peak to Peak Hold", "P-Pホールド", "峰峰值保持"},
    {"Normal", "通常", "通常"},
    {"Reverse", "反転", "反转"},
    {"1 point", "1点", "1点"},
    {"2 points", "2点", "2点"},
    {"3 points", "3点", "3点"},
    {"OFF (No timer)", "OFF(タイマなし)", "OFF(无定时器)"},
    {"On Delay", "オンディレー", "接通延迟"},
    {"Off Delay", "オフディレー", "断开延迟"},
    {"One Shot", "ワンショット", "单次"},
    {"Hold", "ホールド", "保持"},
    {"OFF (Laser emitted)", "OFF(投光)", "OFF(发射)"},
    {"ON (Emission stopped)", "ON(停止)", "ON(停止)"},
    {"4 digits (0.0001)", "4桁 (0.0001)", "4位 (0.0001)"},
    {"3 digits (0.001)", "3桁 (0.001)", "3位 (0.001)"},
    {"2 digits (0.01)", "2桁 (0.01)", "2位 (0.01)"},
    {"1 digit (0.1)", "1桁 (0.1)", "1位 (0.1)"},
    {"0 digits (1)", "0桁 (1)", "0位 (1)"},
    {"Default", "標準", "默认"},
    {"Inverted", "反転", "反转"},
    {"English", "English", "English"}, // each language by its own name, so that one finds back
    {"Japanese", "日本語", "日本語"},
    {"Simplified Chinese", "简体中文", "简体中文"},
    // The display's own words.
    {words::receivedLight, "受光量", "受光量"},
    {words::setTarget, "ワークをセットし ENTERを押す", "放置工件后 按ENTER"},
    {words::setFirstTarget, "1つ目のワークをセットし ENTERを押す", "放置第1个工件后 按ENTER"},
    {words::setSecondTarget, "2つ目のワークをセットし ENTERを押す", "放置第2个工件后 按ENTER"},
    {words::setThirdTarget, "3つ目のワークをセットし ENTERを押す", "放置第3个工件后 按ENTER"},
    {words::adjusting, "調整中", "调整中"},
    {words::success, "成功", "成功"},
    {words::failed, "失敗", "失败"},
    {words::error, "エラー", "错误"},
    {words::keyLockOn, "キーロック ON", "按键锁定 ON"},
    {words::keyLockOff, "キーロック OFF", "按键锁定 OFF"},
    {words::cancel, "キャンセル", "取消"},
    {words::reset, "リセット", "复位"},
    {words::initializing, "初期化中", "初始化中"},
    // The same in every language.
    {words::polarity, words::polarity, words::polarity},
    {words::over, words::over, words::over},
    {words::under, words::under, words::under},
    {words::indeterminate, words::indeterminate, words::indeterminate},
    {words::alarm, words::alarm, words::alarm},
};

const Entry* find(std::string_view english)
{
    const auto entry = std::ranges::find(entries, english, &Entry::english);
    return entry == std::end(entries) ? nullptr : entry;
}

} // namespace

QString panelText(const char* english, PanelLanguage language)
{
    const Entry* entry = language == PanelLanguage::English ? nullptr : find(english);
    if (!entry)
        return QString::fromUtf8(english).replace(u'µ', u'u'); // §4.3.1: "us" stands for microseconds
    return QString::fromUtf8(language == PanelLanguage::Japanese ? entry->japanese : entry->chinese);
}

bool hasPanelText(const char* english) { return find(english) != nullptr; }

} // namespace lds::emulator
