#pragma once

#include "main_window.h"

#include "banner_area.h"
#include "change_communication_dialog.h"
#include "command_desk.h"
#include "connect_dialog.h"
#include "empty_page.h"
#include "messages_page.h"
#include "readout.h"
#include "review_dialog.h"
#include "scan_dialog.h"
#include "session_notices.h"
#include "settings_page.h"
#include "status_line.h"
#include "tool_row.h"
#include "trend_page.h"
#include "window_actions.h"

#include <QDockWidget>
#include <QPointer>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>

namespace lds::ui {

/// For the main window's own files: main_window.cpp makes it, main_window_dialogs.cpp opens its dialogs.
struct MainWindow::Private {
    sensor::Workspace& workspace;
    MessageLog& log;
    ports::Scheduler& scheduler;
    QSettings& settings;
    QPointer<sensor::SensorSession> session = nullptr;
    WindowActions* actions = nullptr;
    CommandDesk* desk = nullptr;
    ToolRow* tools = nullptr;
    QDockWidget* dock = nullptr;
    Readout* readout = nullptr;
    BannerArea* banners = nullptr;
    SessionNotices* notices = nullptr;
    QStackedWidget* stack = nullptr;
    QTabWidget* tabs = nullptr;
    SettingsPage* settingsPage = nullptr;
    TrendPage* trendPage = nullptr;
    MessagesPage* messagesPage = nullptr;
    EmptyPage* emptyPage = nullptr;
    StatusLine* status = nullptr;
    QPointer<ConnectDialog> connectDialog = nullptr;
    QPointer<ReviewDialog> reviewDialog = nullptr;
    QPointer<ScanDialog> scanDialog = nullptr;
    QPointer<ChangeCommunicationDialog> changeDialog = nullptr;
    const ports::SerialPorts* serialPorts = nullptr;
    ports::BusScanFactory* scans = nullptr;
    ports::LinkFactory* links = nullptr;
    bool leaving = false; ///< The person has been asked.
};

} // namespace lds::ui
